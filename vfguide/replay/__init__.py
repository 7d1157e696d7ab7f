"""Replay: what a companion received is fed to the same companion again."""
