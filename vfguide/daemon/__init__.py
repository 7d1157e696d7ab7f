"""The companion on a real link and a real clock."""
