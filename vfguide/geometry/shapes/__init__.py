"""Convex bodies as level functions: one module a family."""
