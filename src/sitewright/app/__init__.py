"""The only place that knows all modules: composes them into what the commands do."""
