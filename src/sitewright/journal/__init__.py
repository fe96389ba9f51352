"""The journal: append-only events with a hash chain, and content-addressed blobs."""
