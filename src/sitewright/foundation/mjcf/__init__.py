"""MuJoCo models as values, and their text."""
