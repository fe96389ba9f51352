"""Drivers: what moves robots, simulated or real."""
