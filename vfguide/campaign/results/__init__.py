"""What a campaign has shown: its report, and its comparison with another one."""
