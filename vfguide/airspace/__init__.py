"""What is in the air and around it: obstacles, traffic, fence."""
