"""From the state of the site to a skill sequence: PDDL, search, validation."""
