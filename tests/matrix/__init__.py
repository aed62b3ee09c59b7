"""The tests on other Pythons, and on other versions of what glshim stands on."""
