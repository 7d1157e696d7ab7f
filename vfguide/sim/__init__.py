"""The simulated aircraft: JSBSim plant and software autopilot."""
