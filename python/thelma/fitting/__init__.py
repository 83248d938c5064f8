"""A material from test data: what `thelma-fit` does."""
