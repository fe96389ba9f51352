"""The page's server and the process of its run, put together."""
