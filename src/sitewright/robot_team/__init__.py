"""Module 5 of the paper: robots, end effectors, skills, and the drivers behind their port."""
