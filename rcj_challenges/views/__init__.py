"""What people look at: scoreboard, replay page."""
