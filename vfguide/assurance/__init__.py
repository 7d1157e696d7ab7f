"""Run-time assurance: what is flown leaves a way out; it knows nothing of what it guards."""
