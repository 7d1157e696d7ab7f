"""A goal as the stages below the loop know it."""

from vfguide.planning.objective import GuidanceTarget

GOAL = GuidanceTarget((0.0, 0.0, -150.0), 0.5, 0.0, 0.0, 0.0)
