"""The reach check in arrays: inverse kinematics and collisions of many postures at once."""
