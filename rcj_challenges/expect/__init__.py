"""Tests in scenario files: plays ``expect`` blocks without physics or programs and compares the outcome.

`runner` plays a block, `scripted_match` feeds poses and touches to a referee, `compare` finds differences, and
`denied` likely reasons for them.
"""
