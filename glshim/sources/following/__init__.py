"""From calls to layers: the follower, the scene of each context, and its layer."""
