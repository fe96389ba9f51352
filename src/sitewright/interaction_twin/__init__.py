"""[4] Interaction twin: what is asked, shown and reported, in plain words."""
