# Repeats a study of the thesis on another valve: how the leak grows as the annulus dilates and flattens.
coapt study annulus porcine-1 -o study
cp study/*.svg dilation.svg
