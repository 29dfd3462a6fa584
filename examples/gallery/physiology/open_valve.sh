# Opens a healthy valve as filling does, prints its opening and gradient, and draws it.
coapt open human-normal --render open_valve.png
