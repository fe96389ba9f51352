"""How a reach check is told: in lines, as a document, as a picture."""
