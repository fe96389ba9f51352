"""Sitewright: from a digital building model to a supervised assembly by a team of robots."""
