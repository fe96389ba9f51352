"""Planners behind the port in `sitewright.symbolic_planning.planner`."""
