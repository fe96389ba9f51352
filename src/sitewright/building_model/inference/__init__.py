"""Facts that a file leaves open, worked out with evidence."""
