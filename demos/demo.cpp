// Filled by the demo framework.
