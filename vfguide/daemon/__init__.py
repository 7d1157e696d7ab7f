"""The companion on a real socket and a real clock."""
