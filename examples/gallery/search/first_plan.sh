# Searches plans from the command line, keeps them as JSON, and draws the valve after the first of them.
few="--evaluations 40 --plans 2 --region-points 5 --model-draws 0 --fine-levels 0 --no-evidence"
coapt plan secondary-mr --seed 1 $few --json > plans.json || [ $? -eq 4 ]
coapt close secondary-mr --plan plans.json --rank 1 --render first_plan.png
