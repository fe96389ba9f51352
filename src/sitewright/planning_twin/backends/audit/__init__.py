"""Proves stored certificates again, by code that shares nothing with planner and prover."""
