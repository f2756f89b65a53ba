//! Typeset symbols.
