"""Engines behind the ports of the planning twin."""
