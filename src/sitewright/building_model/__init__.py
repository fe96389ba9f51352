"""The evolving building model: components, layers, operations, stacks and their checks."""
