"""Module 2 of the paper: decides what is proposed, approved, started and recorded."""
