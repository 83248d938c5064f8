"""The figures of the paper, one module per scene; drawn by scripts/plot."""
