"""Compiled code: functions compiled and kept, records as rows of numbers, loops over points."""
