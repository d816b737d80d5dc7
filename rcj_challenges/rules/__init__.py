"""The words of the scenario language: what a rule may consist of, one file for each word."""
