"""Plane geometry: points, segments, polygons and regions of the floor, without anything of a scenario."""
