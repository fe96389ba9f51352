"""Executors of the skills, one idea per file."""
