"""Sensors, motors and radio: what a program can read and set."""
