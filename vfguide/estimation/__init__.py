"""What is known of the vehicle and of the air: the first stage of the loop."""
