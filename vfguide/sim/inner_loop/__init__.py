"""The inner loop: body rates and thrust to surfaces and throttle, by a measured model."""
