"""A server for avatars that answer: speech comes in over the network, and what is said goes out meanwhile."""
