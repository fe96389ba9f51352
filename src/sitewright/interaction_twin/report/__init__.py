"""After a run: its figures, its pictures and the report page."""
