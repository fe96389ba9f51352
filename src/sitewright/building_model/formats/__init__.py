"""Readers and writers of building files."""
