"""Better places for robots and stock: what may move, where it fits, and how to search."""
