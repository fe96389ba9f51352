"""Values and small laws that every other part builds on."""
