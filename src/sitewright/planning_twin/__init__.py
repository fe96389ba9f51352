"""Module 3 of the paper: turns skills into certified, collision-free motion."""
