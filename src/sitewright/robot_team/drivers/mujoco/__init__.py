"""The simulated cell: MuJoCo physics in a process of its own."""
