// Generated from server/openapi.json by make types.

export type paths = Record<string, never>;
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /**
         * coapt.valve/1: a mitral valve
         * @description Millimetres. Origin at the annulus centroid, x to the posteromedial commissure, y anterior, z to the atrium. Integers are written without a decimal point. Beyond what is said here a reader checks that indices exist and ids differ; that the faces are one orientable sheet, each with its segment and its fibre of length 1; that the annulus is one of its boundary loops, 30 to 400 mm around and centred within 15 mm, with the landmarks in order; that papillary heads of both sides lie below it; that the chordae are trees, and that weights add up to 1.
         */
        Valve: {
            /** @constant */
            schema: "coapt.valve/1";
            name: string;
            /** @description Sources, licences and every change, in order. */
            provenance: string[];
            /** @description Transvalvular. */
            pressure_kpa: number;
            /** @description Moduli below (pre) and above (post) the transition strain. */
            tissue: {
                density_g_per_mm3: number;
                thickness_mm: number;
                circumferential_pre_kpa: number;
                circumferential_post_kpa: number;
                circumferential_transition: number;
                radial_pre_kpa: number;
                radial_post_kpa: number;
                radial_transition: number;
                chordae_kpa: number;
            };
            /** @description The unstressed shape. Edges of faces are 0.02 mm or longer. */
            vertices_mm: components["schemas"]["Valve.point"][];
            /** @description Vertex indices, counter-clockwise seen from the atrial surface. */
            faces: [
                number,
                number,
                number
            ][];
            /** @description One for each face; AC and PC are the commissures, which a valve may lack. Each of the others must be there. */
            segments: ("A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC")[];
            /** @description One for each face: the circumferential direction, a unit vector in its plane. */
            fibre: [
                number,
                number,
                number
            ][];
            /** @description A boundary loop, counter-clockwise seen from the atrium, and where it sits under pressure. */
            annulus: {
                vertices: [
                    number,
                    number,
                    number,
                    number,
                    number,
                    number,
                    ...number[]
                ];
                positions_mm: [
                    components["schemas"]["Valve.point"],
                    components["schemas"]["Valve.point"],
                    components["schemas"]["Valve.point"],
                    components["schemas"]["Valve.point"],
                    components["schemas"]["Valve.point"],
                    components["schemas"]["Valve.point"],
                    ...components["schemas"]["Valve.point"][]
                ];
            };
            /** @description Vertices of the annulus. */
            landmarks: {
                anterolateral_trigone: number;
                posteromedial_trigone: number;
                saddle_peak: number;
                mid_posterior: number;
                anterolateral_commissure: number;
                posteromedial_commissure: number;
            };
            papillary_heads: components["schemas"]["Valve.head"][];
            chordae: components["schemas"]["Valve.chorda"][];
        };
        "Valve.point": [
            number,
            number,
            number
        ];
        "Valve.head": {
            id: string;
            /** @enum {unknown} */
            side: "anterolateral" | "posteromedial";
            /** @description In the unpressurised valve. */
            rest_mm: components["schemas"]["Valve.point"];
            /** @description Under pressure. */
            tip_mm: components["schemas"]["Valve.point"];
        };
        "Valve.chorda": {
            id: string;
            /** @enum {unknown} */
            kind: "marginal" | "strut" | "basal" | "neochorda";
            /** @description Index of the papillary head. */
            head: number;
            ruptured: boolean;
            segments: components["schemas"]["Valve.segment"][];
        };
        "Valve.segment": {
            /** @description -1: the head; else the earlier segment whose branch point it goes on from. */
            parent: number;
            rest_length_mm: number;
            diameter_mm: number;
            /** @description Barycentric weights on the vertices of a face. */
            insertion?: {
                face: number;
                weights: [
                    number,
                    number,
                    number
                ];
            };
            /** @description In the unpressurised valve. */
            branch_point_mm?: components["schemas"]["Valve.point"];
        } & (unknown | unknown);
        /**
         * coapt.plan/1: a repair plan
         * @description Steps in any order; their order does not change the result. Integers are written without a decimal point. Beyond what is said here coapt checks each step against the valve: a suture, for one, is from half the distance between tip and anchor to the whole of it.
         */
        Plan: {
            /** @constant */
            schema: "coapt.plan/1";
            steps: (components["schemas"]["Plan.own_ring"] | components["schemas"]["Plan.catalogue_ring"] | components["schemas"]["Plan.neochorda"] | components["schemas"]["Plan.chordal_length_change"] | components["schemas"]["Plan.chordal_excision"] | components["schemas"]["Plan.chordal_transfer"] | components["schemas"]["Plan.approximation_to_landmark"] | components["schemas"]["Plan.approximation_to_point"])[];
        };
        /** @description along: 0 at the anterolateral, 1 at the posteromedial commissure. height: 0 at the annulus, 1 at the free edge. */
        "Plan.leaflet_point": {
            /** @enum {unknown} */
            leaflet: "anterior" | "posterior";
            along: number;
            height: number;
        };
        /** @description The valve's own annulus, smaller by sizes of 2 mm transverse. */
        "Plan.own_ring": {
            /** @constant */
            step: "annuloplasty";
            /** @constant */
            shape: "own";
            sizes_below: number;
        };
        /** @description A shape of core/repair/rings.h by its labelled transverse size. */
        "Plan.catalogue_ring": {
            /** @constant */
            step: "annuloplasty";
            shape: string;
            size_mm: number;
        };
        "Plan.neochorda": {
            /** @constant */
            step: "neochorda";
            head: string;
            insertion: components["schemas"]["Plan.leaflet_point"];
            length_mm: number;
        };
        "Plan.chordal_length_change": {
            /** @constant */
            step: "chordal_length_change";
            chorda: string;
            /** @description Of the trunk; negative shortens. */
            change_mm: number;
        };
        "Plan.chordal_excision": {
            /** @constant */
            step: "chordal_excision";
            chorda: string;
        };
        "Plan.chordal_transfer": {
            /** @constant */
            step: "chordal_transfer";
            chorda: string;
            insertion: components["schemas"]["Plan.leaflet_point"];
        };
        "Plan.approximation_to_landmark": {
            /** @constant */
            step: "papillary_approximation";
            /** @enum {unknown} */
            side: "anterolateral" | "posteromedial";
            /** @enum {unknown} */
            anchor: "ipsilateral_trigone" | "saddle_peak";
            suture_length_mm: number;
        };
        "Plan.approximation_to_point": {
            /** @constant */
            step: "papillary_approximation";
            /** @enum {unknown} */
            side: "anterolateral" | "posteromedial";
            /** @constant */
            anchor: "annulus_point";
            /** @description 0 posteromedial commissure, 0.25 saddle peak, 0.5 anterolateral commissure, 0.75 mid-posterior. */
            annulus_around: number;
            suture_length_mm: number;
        };
        /**
         * coapt.search/1: how to search for repair plans
         * @description Every field may be left out; the defaults are said here. Integers are written without a decimal point. Beyond what is said here coapt checks the rules against the valve: fixed steps must be possible on it, and forbidden words must say something.
         */
        Search: {
            /**
             * @description Closures for the search itself; ranking takes more. Fewer if nothing is left to try.
             * @default 2000
             */
            evaluations?: number;
            /**
             * @description Same seed, same plans.
             * @default 1
             */
            seed?: number;
            /**
             * @description 0: all cores. Does not change the result.
             * @default 0
             */
            threads?: number;
            /**
             * @description How many ranked plans to report.
             * @default 5
             */
            plans?: number;
            /**
             * @description Nodes of the region of interest, for each reported plan.
             * @default 1089
             */
            region_points?: number;
            /**
             * @description Close the reported plans also under errors of single sutures and further remodelling.
             * @default true
             */
            evidence?: boolean;
            /**
             * @description Stop earlier when this much time is gone, the last 40 % of it spent on ranking; 0: no limit.
             * @default 0
             */
            seconds?: number;
            /**
             * @description Stop searching after so many closures without a better plan; 0: never.
             * @default 0
             */
            no_improvement?: number;
            /**
             * @description Stop searching when mean + sd of a plan's leak over 17 nodes is not above this; -1: never.
             * @default -1
             */
            target_mm2?: number;
            rules?: components["schemas"]["Search.rules"];
            weights?: components["schemas"]["Search.weights"];
        };
        "Search.rules": {
            /** @description Steps that every plan has, as they are. */
            fixed?: {
                /** @constant */
                schema?: "coapt.plan/1";
                steps: components["schemas"]["Plan"]["steps"];
            };
            /** @description Techniques that no plan has: annuloplasty, papillary_approximation, neochorda, chordal_length_change, chordal_excision, chordal_transfer; or, after a colon, one kind of it: annuloplasty:own, annuloplasty:<ring shape>, papillary_approximation:anterolateral, :posteromedial, :ipsilateral_trigone, :saddle_peak, :annulus_point, neochorda:anterior, :posterior. */
            forbidden?: string[];
            /**
             * @description Neochordae that a plan has at most.
             * @default 4
             */
            most_neochordae?: number;
            /**
             * @description Allows shortening the marginal chordae beside a lesion.
             * @default false
             */
            chordal_length_change?: boolean;
            /**
             * @description Allows cutting the anterior leaflet's strut chordae.
             * @default false
             */
            chordal_excision?: boolean;
            /**
             * @description Allows transfer to a lesion.
             * @default false
             */
            chordal_transfer?: boolean;
            /**
             * @description What can be tied.
             * @default 0.5
             */
            suture_lattice_mm?: number;
            /**
             * @description Step between the lengths of a neochorda.
             * @default 1
             */
            neochorda_lattice_mm?: number;
            /**
             * @description Of a papillary muscle: more than 10 is unusual.
             * @default 10
             */
            most_movement_mm?: number;
        };
        /** @description Prices in mm2 of leak. */
        "Search.weights": {
            /**
             * @description Per mm2 of mean + sd_share x sd.
             * @default 1
             */
            leak?: number;
            /**
             * @description Sds that count beside the mean.
             * @default 1
             */
            sd_share?: number;
            /**
             * @description More, per mm2 of that above 1.
             * @default 5
             */
            incompetence?: number;
            /**
             * @description For a plan that leaks at once; none if no disturbance makes it leak.
             * @default 1
             */
            margin?: number;
            /**
             * @description Per mm that A2 with P2 falls short of 8.
             * @default 0.5
             */
            coaptation?: number;
            /**
             * @description Per mm by which leaflets are further apart than they are thick.
             * @default 2
             */
            gap?: number;
            /**
             * @description Per mm of papillary movement.
             * @default 0.2
             */
            movement?: number;
            /**
             * @description More, per mm above what is usual.
             * @default 1
             */
            movement_above_10?: number;
            /**
             * @description Per ring size.
             * @default 0.5
             */
            undersizing?: number;
            /**
             * @description More, per size above what practice accepts.
             * @default 2
             */
            undersizing_above_4?: number;
            /**
             * @description Per step.
             * @default 1
             */
            step?: number;
            /**
             * @description Per newton of peak chordal tension above the unrepaired valve's.
             * @default 1
             */
            tension?: number;
            /**
             * @description For closures that did not converge or crossed, by their share.
             * @default 10000
             */
            untrusted?: number;
        };
        /** @description What coapt is not. */
        Notice: string;
        /** @description Of a valve: SHA-256 of its document as the service writes it. Of a job or a kept plan: 128 random bits. */
        Id: string;
        /**
         * Format: date-time
         * @description RFC 3339, UTC, milliseconds.
         */
        Time: string;
        /** @description To be sent as page_token for the next page; null: this is the last. */
        NextPageToken: string | null;
        /** @description A valve, or in a word: the id of a stored one, or a preset's name. */
        ValveSource: components["schemas"]["Valve"] | string;
        Fault: {
            /** @enum {string} */
            code: "invalid_json" | "missing_field" | "unknown_field" | "wrong_type" | "out_of_range" | "bad_reference" | "bad_topology" | "bad_geometry" | "impossible_step" | "unsupported" | "input_output" | "busy" | "no_space";
            /** @description JSON pointer into the request's body; ?NAME: a parameter of the query; empty: the whole of the request. */
            path: string;
            /** @description What is wrong, and what is accepted. */
            message: string;
        };
        /** @description RFC 9457. */
        Problem: {
            /** @constant */
            type: "about:blank";
            title: string;
            status: number;
            /** @description The first of the problems, or a general sentence. */
            detail: string;
            /** @description All of them, not only the first. */
            problems: components["schemas"]["Fault"][];
            notice: components["schemas"]["Notice"];
        };
        StoredValve: {
            id: components["schemas"]["Id"];
            vertices: number;
            triangles: number;
            chordae: number;
            notice: components["schemas"]["Notice"];
        };
        Validation: {
            valid: boolean;
            problems: components["schemas"]["Fault"][];
            notice: components["schemas"]["Notice"];
        };
        Valves: {
            /** @description Newest first. */
            valves: {
                valve: components["schemas"]["Id"];
                /** @description Of its document. */
                name: string;
                /** @description Of its leaflets. */
                vertices: number;
                /** @description Of its leaflets. */
                triangles: number;
            }[];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        PlanToKeep: {
            /** @description For people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
            /** @description The id of a stored valve, or a preset's name. */
            valve: string;
            plan: components["schemas"]["Plan"];
        };
        NewName: {
            /** @description For people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
        };
        KeptPlan: {
            kept_plan: components["schemas"]["Id"];
            /** @description For people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
            /** @description The id of a stored valve, or a preset's name. */
            valve: string;
            plan: components["schemas"]["Plan"];
            notice?: components["schemas"]["Notice"];
        };
        KeptPlans: {
            /** @description Newest first. */
            kept_plans: components["schemas"]["KeptPlan"][];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        /** @description Of a search: the best plan so far. One closed at more nodes comes before one closed at fewer. */
        LeadingPlan: {
            /** @description mm2, over its nodes; lower is better. */
            cost: number | null;
            /** @description Of the region of interest, closed so far. */
            nodes: number;
            /** @description As planned. */
            leak_mm2: number | null;
            description: components["schemas"]["RankedPlan"]["description"];
            plan: components["schemas"]["Plan"];
        };
        Presets: {
            presets: {
                name: string;
                /**
                 * Format: uri-reference
                 * @description Path of its document.
                 */
                valve: string;
            }[];
            notice: components["schemas"]["Notice"];
        };
        Rings: {
            rings: {
                /** @description What a plan's step calls its shape. */
                name: string;
                ap_over_transverse: number;
                /** @description True transverse width over the labelled size. */
                transverse_factor: number;
                /** @description Height of the saddle. */
                saddle_over_transverse: number;
                note: string;
            }[];
            /** @description Labelled transverse sizes. */
            sizes_mm: {
                min: number;
                max: number;
                step: number;
            };
            notice: components["schemas"]["Notice"];
        };
        /** @description Of a closed valve. Null: the closure flew apart, so nothing is known but its annulus. */
        Measure: {
            /** @description Of the view from the atrium, leaflets with their half thickness. */
            orifice_area_mm2: number | null;
            /** @description Leaflets as bare mid-surfaces. */
            orifice_area_raw_mm2: number | null;
            /** @description Mean over closely spaced end states. */
            orifice_area_mean_mm2: number | null;
            /** @description The larger of orifice and gap: what a competent valve keeps near zero. */
            leak_mm2: number | null;
            /** @description Largest first. */
            orifices: {
                area_mm2: number;
                /** @description On the annular plane. */
                centroid_mm: [
                    number,
                    number,
                    number
                ];
                /** @enum {unknown} */
                segment: "A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC";
            }[];
            coaptation: {
                height_min_mm: number | null;
                height_mean_mm: number | null;
                height_p10_mm: number | null;
                /** @description The widest of the sections' smallest distances. */
                distance_max_mm: number | null;
                /** @description Opening between the leaflets in three dimensions. */
                gap_area_mm2: number | null;
                /** @description Nine, across the line of coaptation. */
                sections: {
                    /** @description 0 anterolateral, 1 posteromedial commissure. */
                    along: number;
                    height_mm: number | null;
                    distance_mm: number | null;
                    contact: boolean;
                }[];
            };
            annulus: {
                ap_mm: number;
                al_pm_mm: number;
                circumference_mm: number;
                /** @description Projected. */
                area_mm2: number;
                saddle_height_mm: number;
            };
            /** @description Below 0 where leaflets billow. */
            tenting_height_mm: number | null;
            tenting_area_mm2: number | null;
            /** @description Of a chorda. */
            tension_max_n: number | null;
            /** @description Over segments that leave a papillary head. */
            tension_sum_n: number | null;
            /** @description 99th percentile over triangles. */
            strain_circumferential_max: number | null;
            /** @description Likewise. */
            strain_radial_max: number | null;
        };
        /** @description coapt.closure/1, as `coapt close --json` prints it. */
        Closure: components["schemas"]["Measure"] & {
            /** @constant */
            schema: "coapt.closure/1";
            version: string;
            notice: components["schemas"]["Notice"];
            /** @description Its name. */
            valve: string;
            triangles: number;
            /** @enum {unknown} */
            method: "fast" | "thesis";
            /** @enum {unknown} */
            membrane: "springs" | "continuum";
            /** @enum {unknown} */
            status: "converged" | "step_limit" | "diverged";
            /** @description rms free force / rms pressure force. */
            residual: number | null;
            steps: number;
            seconds: number;
            /** @description Whether leaflets pass through each other: then the figures do not count. */
            crossing: boolean;
            /** @description Of triangles. */
            crossing_pairs: number;
            /** @description From quick to careful, until one is converged and uncrossed. */
            attempts: {
                how: string;
                /** @enum {unknown} */
                status: "converged" | "step_limit" | "diverged";
                crossing_pairs: number;
                residual: number | null;
                steps: number;
            }[];
            warnings: string[];
        };
        /** @description x, y, z, x, y, z, ... in mm, rounded to 0.001. */
        FlatPoints: number[];
        /** @description coapt.scene/1: all that is drawn of a closed valve. Indices count from 0. */
        Scene: {
            /** @constant */
            schema: "coapt.scene/1";
            notice: components["schemas"]["Notice"];
            /** @description The annulus's plane of best fit: x posteromedial, y anterior, normal to the atrium. */
            plane: {
                origin_mm: components["schemas"]["Vector"];
                x: components["schemas"]["Vector"];
                y: components["schemas"]["Vector"];
                normal: components["schemas"]["Vector"];
            };
            /** @description Of the leaflets. */
            thickness_mm: number;
            /** @description Vertices of the unstressed leaflets. */
            rest_mm: components["schemas"]["FlatPoints"];
            /** @description The same under pressure; null if the closure flew apart. */
            closed_mm: components["schemas"]["FlatPoints"] | null;
            /** @description Three vertices each. */
            faces: number[];
            /** @description Of each face. */
            segments: ("A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC")[];
            /** @description Of each vertex. around: 0 at the posteromedial commissure, 0.25 at the saddle peak, 0.5 at the anterolateral commissure, 0.75 at mid-posterior. height: 0 at the annulus, 1 at the free edge. */
            leaflet_coordinates: {
                around: number[];
                height: number[];
            };
            /** @description Its vertices, in order. */
            annulus: number[];
            /** @description Where they sit under pressure. */
            annulus_mm: components["schemas"]["FlatPoints"];
            /** @description Vertices of the annulus. */
            landmarks: {
                [key: string]: number;
            };
            /** @description Of the papillary muscles; tip_mm under pressure. */
            heads: {
                id: string;
                /** @enum {unknown} */
                side: "anterolateral" | "posteromedial";
                rest_mm: components["schemas"]["Vector"];
                tip_mm: components["schemas"]["Vector"];
            }[];
            chordae: {
                id: string;
                /** @enum {unknown} */
                kind: "marginal" | "strut" | "basal" | "neochorda";
                /** @description Index into heads. */
                head: number;
                ruptured: boolean;
                /** @description From the head to the leaflet; they branch. */
                segments: {
                    /** @description At whose end it starts; -1: at the head. */
                    parent: number;
                    end_mm: components["schemas"]["Vector"];
                    tension_n: number | null;
                    /** @description Into which it inserts; missing: it ends in a branch point. */
                    face?: number;
                    /** @description Of the corners of the face. */
                    weights?: components["schemas"]["Vector"];
                }[];
            }[];
            /** @description Of the plan: from the mean tip of a papillary muscle to its anchor on the annulus. */
            sutures: {
                /** @enum {unknown} */
                side: "anterolateral" | "posteromedial";
                tip_mm: components["schemas"]["Vector"];
                anchor_mm: components["schemas"]["Vector"];
            }[];
            /** @description Green-Lagrange strain of each face. */
            strain: {
                circumferential: number[];
                radial: number[];
            } | null;
            /** @description Of the view from the atrium, largest first: the line around each, then those around islands of tissue in it. Seen from the atrium they are the orifice; each point is as high as the tissue beside it, so a membrane across the lines lies where the valve is open. */
            orifices: {
                area_mm2: number;
                contours_mm: components["schemas"]["FlatPoints"][];
            }[];
            /** @description 37 planes across the line between the commissures. */
            sections: {
                /** @description 0 at the anterolateral commissure, 1 at the posteromedial one. */
                along: number;
                point_mm: components["schemas"]["Vector"];
                normal: components["schemas"]["Vector"];
                /** @description Of coaptation. */
                height_mm: number;
                /** @description Smallest between the leaflets' mid-surfaces; null without anterior tissue. */
                distance_mm: number | null;
                contact: boolean;
                /** @description Where the leaflets' mid-surfaces are nearest to each other: on the anterior side, in the section, and on the posterior side; null without anterior tissue. Lines between them, over neighbouring sections without contact, span the gap. */
                nearest_mm: [
                    components["schemas"]["Vector"],
                    components["schemas"]["Vector"]
                ] | null;
            }[];
            /** @description States on the way from open to closed, which is not that of real time: vertices, branch points of chordae, heads. */
            motion_mm: components["schemas"]["FlatPoints"][];
            closure: components["schemas"]["Closure"];
        };
        Vector: [
            number,
            number,
            number
        ];
        /** @description mm2, over the region of interest. Null: fewer than two of its nodes were closed, which says nothing of it. */
        Statistics: {
            /** @description As planned. */
            nominal: number | null;
            mean: number | null;
            sd: number | null;
            worst: number | null;
            /** @description 95th percentile. */
            p95: number | null;
            /** @description Share of the region below 5 mm2. */
            below_5: number | null;
            below_10: number | null;
            below_20: number | null;
        };
        RankedPlan: {
            /** @description 1: the best. */
            rank: number;
            plan: components["schemas"]["Plan"];
            /** @description In surgical words, a line a step. */
            description: string[];
            orifice_area_mm2: components["schemas"]["Statistics"];
            leak_mm2: components["schemas"]["Statistics"];
            /** @description mm2; lower is better. */
            cost: number | null;
            /** @enum {unknown} */
            status: "converged" | "step_limit" | "diverged";
            crossing: boolean;
            measure: components["schemas"]["Measure"];
            steps: number;
            /** @description Of 2 mm. */
            ring_sizes_below: number;
            anterolateral_movement_mm: number;
            posteromedial_movement_mm: number;
            region_closures: number;
            /** @description Of these: not converged, or crossed. */
            region_failures: number;
            margin_to_leak: {
                suture_length_mm: number | null;
                angle_deg: number | null;
                /** @description Of the way to the region's border; 1: no node leaks. */
                share: number | null;
            };
            /** @description Pareto-optimal among the ranked plans in mean leak, its sd, steps and undersizing. */
            pareto: boolean;
            probability_outranks_next: number | null;
            tie_with_next: boolean;
            /** @description The nodes by which it was chosen. */
            subset: {
                nodes: number;
                cost: number | null;
            };
            leak_map: {
                /** @enum {unknown} */
                muscle: "both" | "anterolateral" | "posteromedial";
                suture_length_mm: number[];
                outwards_deg: number[];
                /** @description Rows by length, columns by angle. Null: not closed. */
                leak_mm2: (number | null)[][];
            }[];
            /** @description Shares of the leak's variance. */
            sobol: {
                first: {
                    suture_length: number | null;
                    outwards: number | null;
                    posterior: number | null;
                };
                total: {
                    suture_length: number | null;
                    outwards: number | null;
                    posterior: number | null;
                };
            };
            /** @description Two sutures, each with its own error. */
            independent_leak_mm2: components["schemas"]["Statistics"];
            remodelling: {
                direction: string;
                /** @description At 0, 1, ... 6 mm. */
                leak_mm2: (number | null)[];
            }[];
            /** @description Sixteen rules of practice. */
            gates: {
                rule: string;
                /** @enum {unknown} */
                severity: "pass" | "warn" | "reject" | "not_assessed";
                finding: string;
                source: string;
            }[];
            /** @description Of gates and region, in words. */
            warnings: string[];
            notice?: components["schemas"]["Notice"];
        };
        /** @description The valve as it is. */
        Before: components["schemas"]["Measure"] & {
            /** @enum {unknown} */
            status: "converged" | "step_limit" | "diverged";
            crossing: boolean;
        };
        /** @description coapt.plans/1, as `coapt plan --json` prints it. */
        Plans: {
            /** @constant */
            schema: "coapt.plans/1";
            version: string;
            notice: components["schemas"]["Notice"];
            before: components["schemas"]["Before"];
            /** @description Whether a plan closes the valve also when the surgeon's hand varies. */
            any_competent: boolean;
            /** @description Best first. */
            plans: components["schemas"]["RankedPlan"][];
            best_cost_history: (number | null)[];
            progress: {
                closures: number;
                cost: number | null;
            }[];
            /** @description What plans tried at random are expected to reach. */
            random_progress: {
                closures: number;
                cost: number | null;
            }[];
            pareto_front: {
                plan: components["schemas"]["Plan"];
                description: string[];
                mean_mm2: number | null;
                sd_mm2: number | null;
                steps: number;
                ring_sizes_below: number;
                nodes: number;
            }[];
            ladder: {
                from: number;
                to: number;
                plans: number;
                spearman: number | null;
                skipped: boolean;
            }[];
            branches: number;
            /** @description What was left out. */
            cut: {
                what: string;
                why: string;
            }[];
            plans_possible: number;
            plans_tried: number;
            /** @enum {unknown} */
            stop: "evaluation_limit" | "exhausted" | "no_improvement" | "target_reached" | "time_limit" | "cancelled";
            /** @description All of them, known ones included. */
            closures: number;
            /** @description Closures of the search itself: neither of the valve as it is nor of ranking. */
            evaluations: number;
            /** @description From an earlier run. */
            closures_known: number;
            closures_not_converged: number;
            closures_crossed: number;
            seconds: number;
            not_modelled: string[];
            weights: components["schemas"]["Search"]["weights"];
            reproduce: {
                valve_hash: string;
                version: string;
                seed: number;
                /** @description Empty: a request has none. */
                command: string;
                search: components["schemas"]["Search"];
            };
        };
        PlansToScore: {
            valve: components["schemas"]["ValveSource"];
            plans: [
                components["schemas"]["Plan"],
                ...components["schemas"]["Plan"][]
            ];
            /**
             * @description Nodes of each plan's region of interest.
             * @default 1
             */
            region_points?: number;
            /**
             * @description Also errors of single sutures and further remodelling: 24 to 284 closures more for each plan.
             * @default false
             */
            evidence?: boolean;
        };
        Evaluations: {
            version: string;
            before: components["schemas"]["Before"];
            /** @description In the order asked, each with its rank. */
            plans: (components["schemas"]["RankedPlan"] & {
                /** @description Its place in the request, from 0. */
                index: number;
            })[];
            any_competent: components["schemas"]["Plans"]["any_competent"];
            ladder: components["schemas"]["Plans"]["ladder"];
            /** @description Different ones. */
            plans_tried: number;
            closures: number;
            closures_not_converged: number;
            closures_crossed: number;
            seconds: number;
            not_modelled: string[];
            notice: components["schemas"]["Notice"];
        };
        Study: {
            /** @enum {unknown} */
            name: "annulus" | "papillary" | "ring";
        } | {
            /** @enum {unknown} */
            name: "approximation" | "thesis";
            /**
             * @description How positions of a region get their orifice.
             * @default [
             *       "lookup-clamped",
             *       "lookup-extended"
             *     ]
             */
            protocols?: [
                "lookup-clamped" | "lookup-extended" | "closed" | "optimum",
                ...("lookup-clamped" | "lookup-extended" | "closed" | "optimum")[]
            ];
            /**
             * @description Of the displaced configurations.
             * @enum {unknown}
             */
            displacement_step_mm?: 1 | 2 | 3 | 6;
            /** @description Of the region's 1,089. */
            region_points?: number;
            /** @description Anchors around the annulus, besides trigone and saddle peak. */
            scan_sites?: number;
        };
        StudyResult: {
            study: string;
            /** @description Its name. */
            valve: string;
            version: string;
            /** @description Five end states each. */
            configurations: number;
            /** @description Made now. */
            closures: number;
            /** @description Not converged, or crossed. */
            untrusted: number;
            seconds: number;
            findings: {
                finding: string;
                /** @description Of the thesis. */
                section: string;
                thesis: string;
                ours: string;
                judged: string;
                agrees: boolean;
            }[];
            /** @description Findings that agree with the thesis. */
            agree: number;
            notice: components["schemas"]["Notice"];
        };
        /** @enum {unknown} */
        JobState: "QUEUED" | "RUNNING" | "SUCCEEDED" | "FAILED" | "CANCELLED";
        Progress: {
            stage: string;
            /** @description Of a search: so far, of any kind, known ones included. Of a study: made in its present stage. */
            closures: number;
            closures_planned: number;
            /** @description Of plans as planned, so far. */
            best_leak_mm2: number | null;
            /** @description mm2; of a search, at one closure a plan, so far. */
            best_cost: number | null;
            /** @description What trying plans at random is expected to have after as many closures; null until some were tried. */
            random_cost: number | null;
            /** @description Of running, over all attempts. */
            seconds: number;
            best?: components["schemas"]["LeadingPlan"];
        };
        PlanSummary: {
            /** @description 1: the best. */
            rank: number;
            description: components["schemas"]["RankedPlan"]["description"];
            plan: components["schemas"]["Plan"];
            orifice_area_mm2: components["schemas"]["Statistics"];
            leak_mm2: components["schemas"]["Statistics"];
            /** @description mm2; lower is better. */
            cost: number | null;
            /** @enum {unknown} */
            status: "converged" | "step_limit" | "diverged";
            crossing: boolean;
            margin_to_leak: components["schemas"]["RankedPlan"]["margin_to_leak"];
            tie_with_next: boolean;
            warnings: components["schemas"]["RankedPlan"]["warnings"];
        };
        Job: {
            id: components["schemas"]["Id"];
            /** @enum {unknown} */
            kind: "plans" | "study";
            state: components["schemas"]["JobState"];
            created: components["schemas"]["Time"];
            started: components["schemas"]["Time"] | null;
            finished: components["schemas"]["Time"] | null;
            valve: components["schemas"]["Id"];
            cancel_requested: boolean;
            /** @description Of a running job that stands still, because nothing can be stored now: why. It goes on by itself. */
            waiting_for: string | null;
            /** @description Jobs before it; null: it does not wait. */
            queue_position: number | null;
            progress: components["schemas"]["Progress"];
            /** @description Of a failed job: why. */
            problems: components["schemas"]["Fault"][];
            /** @description Of a search: best first; null: it has not ended. A page of jobs leaves it out. */
            plans?: components["schemas"]["PlanSummary"][] | null;
            stop?: components["schemas"]["Plans"]["stop"];
            /** @description Of a search that has ended: see its result. */
            any_competent?: boolean;
            /** @description Of a study that has ended. */
            findings?: number;
            /** @description Of these: with the thesis. */
            agree?: number;
            /** @description Paths. Those of results once there are some; plans and evaluations only of a search. */
            links: {
                /** Format: uri-reference */
                self: string;
                /** Format: uri-reference */
                events: string;
                /** Format: uri-reference */
                cancel: string;
                /** Format: uri-reference */
                result?: string;
                /** Format: uri-reference */
                plans?: string;
                /** Format: uri-reference */
                evaluations?: string;
                /** Format: uri-reference */
                report?: string;
                /** Format: uri-reference */
                files?: string;
            };
            notice?: components["schemas"]["Notice"];
        };
        Jobs: {
            /** @description Newest first, without their plans. */
            jobs: components["schemas"]["Job"][];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        PlansPage: {
            /** @description By rank. */
            plans: components["schemas"]["RankedPlan"][];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        Files: {
            files: {
                name: string;
                /** @description Media type. */
                type: string;
                bytes: number;
                /** Format: uri-reference */
                path: string;
            }[];
            notice: components["schemas"]["Notice"];
        };
        Live: {
            /** @constant */
            status: "live";
            notice: components["schemas"]["Notice"];
        };
        Ready: {
            /** @constant */
            status: "ready";
            /** @description Of a small valve, just now. */
            closure_ms: number;
            jobs_queued: number;
            jobs_running: number;
            notice: components["schemas"]["Notice"];
        };
        Version: {
            /** @constant */
            name: "coapt-server";
            version: string;
            /** @constant */
            api: "v1";
            /** @description What the model leaves out, in sentences. */
            not_modelled: string[];
            notice: components["schemas"]["Notice"];
        };
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export type operations = Record<string, never>;
