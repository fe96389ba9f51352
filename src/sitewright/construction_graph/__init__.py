"""The construction relationship graph of the paper: what rests on what, and what comes next."""
