"""HTTP and WebSocket of the page."""
