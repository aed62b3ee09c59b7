"""One run of a program: start-up, session, launch, clocks that stand still, galleries, shots."""
