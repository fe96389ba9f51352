"""How each skill becomes certified motion: one file per family of skills."""
