"""The central controller: proposal, approval, guard, and the cycle as a pure step function."""
