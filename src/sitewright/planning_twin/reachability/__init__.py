"""Reachability known beforehand: what is asked for the whole model, and what the answer means."""
