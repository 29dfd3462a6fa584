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
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.valve/1";
            /** @description Name for people to read. */
            name: string;
            /** @description Sources, licences and every change, in order. */
            provenance: string[];
            /** @description Pressure across the closed valve, at the peak of systole. */
            pressure_kpa: number;
            /** @description How far systole moves annulus and tips, whose places under pressure the file has. Left out: 0.3 and 0.3, as in health. */
            systole?: {
                /** @description Share of the annulus's diastolic area that systole takes away; 0 behind a ring. */
                annular_contraction: number;
                /** @description Share of the papillary tips' diastolic distance from each other that systole takes away. */
                tip_approach: number;
            };
            /** @description Moduli below (pre) and above (post) the transition strain. */
            tissue: {
                /** @description Density of leaflets and chordae. */
                density_g_per_mm3: number;
                /** @description Thickness of the leaflets, the same everywhere. */
                thickness_mm: number;
                /** @description Modulus along the fibres below the transition strain. */
                circumferential_pre_kpa: number;
                /** @description Modulus along the fibres above the transition strain. */
                circumferential_post_kpa: number;
                /** @description Strain along the fibres at which the modulus changes. */
                circumferential_transition: number;
                /** @description Modulus across the fibres below the transition strain. */
                radial_pre_kpa: number;
                /** @description Modulus across the fibres above the transition strain. */
                radial_post_kpa: number;
                /** @description Strain across the fibres at which the modulus changes. */
                radial_transition: number;
                /** @description Modulus of the chordae. */
                chordae_kpa: number;
                /**
                 * @description What vertices_mm and transition strains are counted from: excised, the shape free of stress; in_vivo, the shape in the unpressurised heart, which the prestretches have stretched already.
                 * @default excised
                 * @enum {string}
                 */
                reference?: "excised" | "in_vivo";
                /**
                 * @description Length along the fibres in the unpressurised heart over the excised one. Counts with reference in_vivo.
                 * @default 1.0761904761904761
                 */
                circumferential_prestretch?: number;
                /**
                 * @description Length across the fibres in the unpressurised heart over the excised one. Counts with reference in_vivo.
                 * @default 1.1875
                 */
                radial_prestretch?: number;
                /**
                 * @description Flexural rigidity of the leaflets; 0: a membrane.
                 * @default 0.03
                 */
                bending_n_mm?: number;
            };
            /** @description The unstressed shape. Edges of faces are 0.02 mm or longer. */
            vertices_mm: components["schemas"]["Valve.point"][];
            /** @description Vertex indices, counter-clockwise seen from the atrial surface. */
            faces: [
                number,
                number,
                number
            ][];
            /** @description Segment of each face; AC and PC are the commissures, which a valve may lack. Each of the others must be there. */
            segments: ("A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC")[];
            /** @description One for each face: the circumferential direction, a unit vector in its plane. */
            fibre: [
                number,
                number,
                number
            ][];
            /** @description A boundary loop, counter-clockwise seen from the atrium, and where it sits under pressure. */
            annulus: {
                /** @description Vertex indices, in order around the loop. */
                vertices: [
                    number,
                    number,
                    number,
                    number,
                    number,
                    number,
                    ...number[]
                ];
                /** @description Place of each of these vertices under pressure. */
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
                /** @description Vertex at the trigone on the anterolateral side. */
                anterolateral_trigone: number;
                /** @description Vertex at the trigone on the posteromedial side. */
                posteromedial_trigone: number;
                /** @description Vertex at the saddle peak, the middle of the anterior annulus. */
                saddle_peak: number;
                /** @description Vertex at the middle of the posterior annulus. */
                mid_posterior: number;
                /** @description Vertex at the anterolateral commissure. */
                anterolateral_commissure: number;
                /** @description Vertex at the posteromedial commissure. */
                posteromedial_commissure: number;
            };
            /** @description Heads of the papillary muscles, where chordae start. */
            papillary_heads: components["schemas"]["Valve.head"][];
            /** @description Chordae, each a tree from one papillary head to one or more insertions. */
            chordae: components["schemas"]["Valve.chorda"][];
            /** @description Sutures or clips that hold two points of the leaflets together: tension only. */
            ties?: {
                /** @description Unique. */
                id: string;
                anterior: components["schemas"]["Valve.insertion"];
                posterior: components["schemas"]["Valve.insertion"];
                /** @description Slack up to this length. */
                rest_length_mm: number;
                /** @description Radius of the disc of either leaflet that it pulls at. */
                zone_mm: number;
                /** @description Beyond it. */
                stiffness_n_per_mm: number;
            }[];
            /** @description There if chordae and heads were drawn from anatomy because images show none. */
            drawn_chordae?: {
                /** @description Of the draw; 0: the mean anatomy. */
                seed: number;
                /** @description The papillary tips were seen; else they are drawn, too. */
                tips_given: boolean;
            };
            /** @description There if the valve was fitted to a closed surface (coapt fit): what that left uncertain. A search draws from it. */
            fit?: {
                /** @description Names, as coapt fit prints them. */
                parameters: string[];
                /** @description Of what may be added to each, mm or 1; of a slack, to a factor of 1 on the lengths as they are. Symmetric, positive semidefinite. */
                covariance: number[][];
            };
            /** @description From the valve's frame to that of the images it was made from (LPS, mm): four rows, the upper left 3 x 3 numbers a rotation, the last row 0, 0, 0, 1. Left out: not known. */
            patient_frame?: [
                [
                    number,
                    number,
                    number,
                    number
                ][],
                [
                    number,
                    number,
                    number,
                    number
                ][],
                [
                    number,
                    number,
                    number,
                    number
                ][],
                [
                    number,
                    number,
                    number,
                    number
                ][]
            ];
        };
        /** @description Barycentric weights on the vertices of a face. */
        "Valve.insertion": {
            /** @description Index of the face. */
            face: number;
            /** @description One for each vertex of the face; together 1. */
            weights: [
                number,
                number,
                number
            ];
        };
        "Valve.point": [
            number,
            number,
            number
        ];
        "Valve.head": {
            /** @description Unique name, such as AL1. */
            id: string;
            /**
             * @description Papillary muscle to which it belongs.
             * @enum {string}
             */
            side: "anterolateral" | "posteromedial";
            /** @description Place in the unpressurised valve. */
            rest_mm: components["schemas"]["Valve.point"];
            /** @description Place under pressure; it does not move during closure. */
            tip_mm: components["schemas"]["Valve.point"];
        };
        "Valve.chorda": {
            /** @description Unique name, such as AL1-P2-marginal-1. */
            id: string;
            /**
             * @description Where it inserts: marginal at the free edge, strut and basal away from it; neochorda: artificial.
             * @enum {string}
             */
            kind: "marginal" | "strut" | "basal" | "neochorda";
            /** @description Index of the papillary head. */
            head: number;
            /** @description Whether it is ruptured and carries nothing. */
            ruptured: boolean;
            /** @description Straight pieces; a piece comes after its parent. */
            segments: components["schemas"]["Valve.segment"][];
        };
        "Valve.segment": {
            /** @description -1: the head; else the earlier segment whose branch point it goes on from. */
            parent: number;
            /** @description Length without tension. */
            rest_length_mm: number;
            /** @description Diameter of its cross-section. */
            diameter_mm: number;
            /** @description Modulus of this piece; left out: that of the tissue's chordae. */
            modulus_kpa?: number;
            insertion?: components["schemas"]["Valve.insertion"];
            /**
             * @description Radius of the disc of the leaflet that an inserting segment pulls at; 0: the face of the insertion alone.
             * @default 2
             */
            zone_mm?: number;
            /** @description Place in the unpressurised valve. */
            branch_point_mm?: components["schemas"]["Valve.point"];
        } & (unknown | unknown);
        /**
         * coapt.plan/1: a repair plan
         * @description Steps in any order; their order does not change the result. Integers are written without a decimal point. Beyond what is said here coapt checks each step against the valve: a suture, for one, is from half the distance between tip and anchor to the whole of it.
         */
        Plan: {
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.plan/1";
            /** @description Surgical steps; none: the valve stays as it is. */
            steps: (components["schemas"]["Plan.annuloplasty"] | components["schemas"]["Plan.neochorda"] | components["schemas"]["Plan.chordal_length_change"] | components["schemas"]["Plan.chordal_excision"] | components["schemas"]["Plan.chordal_transfer"] | components["schemas"]["Plan.papillary_approximation"] | components["schemas"]["Plan.edge_to_edge"] | components["schemas"]["Plan.leaflet_resection"])[];
        };
        /** @description A point of a leaflet, the same on every mesh. */
        "Plan.leaflet_point": {
            /**
             * @description Leaflet on which the point lies.
             * @enum {string}
             */
            leaflet: "anterior" | "posterior";
            /** @description 0 at the anterolateral, 1 at the posteromedial commissure. */
            along: number;
            /** @description 0 at the annulus, 1 at the free edge. */
            height: number;
        };
        /** @description A ring sutured to the annulus. */
        "Plan.annuloplasty": {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            step: "annuloplasty";
        } & (components["schemas"]["Plan.own_ring"] | components["schemas"]["Plan.catalogue_ring"] | components["schemas"]["Plan.designed_ring"]);
        /** @description A ring in the shape of the valve's own annulus, made smaller in proportion. */
        "Plan.own_ring": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "annuloplasty";
            /**
             * @description The shape of the valve's own annulus. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            shape: "own";
            /** @description Sizes of 2 mm by which the annulus gets narrower. */
            sizes_below: number;
        };
        /** @description A ring of the catalogue. */
        "Plan.catalogue_ring": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "annuloplasty";
            /**
             * @description A shape of the catalogue, none of them a manufacturer's. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            shape: "generic-classic" | "generic-etlogix-like" | "generic-geoform-like";
            /** @description Labelled transverse size, in steps of 2 mm. */
            size_mm: number;
        };
        /** @description A ring of a designed shape. */
        "Plan.designed_ring": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "annuloplasty";
            /**
             * @description A shape of one's own. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            shape: "designed";
            ring: components["schemas"]["Plan.designed_shape"];
            /** @description True width, in steps of 2 mm. */
            size_mm: number;
        };
        /** @description A designed shape; all lengths are shares of the ring's width. */
        "Plan.designed_shape": {
            /** @description By which plans and rules know it; none of the catalogue's. */
            name: string;
            /** @description From the middle of the front to the middle of the back. */
            ap_over_transverse: number;
            /** @description Of the front, by which the back gets rounder. */
            flattening: number;
            /** @description P3 drawn in, forwards; negative: let out. */
            p3_inset: number;
            /** @description Front's middle above the ends. */
            saddle: number;
            /** @description Of the back's middle, beyond the saddle. */
            elevation: number;
            /** @description Of P3; negative: it lies lower. */
            p3_elevation: number;
        };
        /** @description An artificial chorda: a suture from a papillary head to the leaflet. */
        "Plan.neochorda": {
            /**
             * @description Kind of step. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            step: "neochorda";
            /** @description Id of the papillary head from which it starts. */
            head: string;
            /** @description Where it is sutured to the leaflet. */
            insertion: components["schemas"]["Plan.leaflet_point"];
            /** @description Length without tension. */
            length_mm: number;
        };
        /** @description A chorda made shorter or longer. */
        "Plan.chordal_length_change": {
            /**
             * @description Kind of step. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            step: "chordal_length_change";
            /** @description Id of the chorda. */
            chorda: string;
            /** @description Change of the length of its trunk, the part at the papillary head; below 0: shorter. */
            change_mm: number;
        };
        /** @description A chorda cut, so that it carries nothing. */
        "Plan.chordal_excision": {
            /**
             * @description Kind of step. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            step: "chordal_excision";
            /** @description Id of the chorda. */
            chorda: string;
        };
        /** @description Opposite points of the free edges are held together. */
        "Plan.edge_to_edge": {
            /**
             * @description Kind of step. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            step: "edge_to_edge";
            /**
             * @description A stitch along both free edges (Alfieri), or a clip, whose arms hold the leaflets 5 mm above them, too.
             * @enum {string}
             */
            device: "stitch" | "clip";
            /** @description Place on both edges: 0 anterolateral commissure, 0.5 A2 to P2, 1 posteromedial commissure. */
            along: number;
            /** @description Along the edges. */
            width_mm: number;
        };
        /** @description Tissue of a leaflet is cut out with the chordae that it holds, and the edges of the cut are sewn together. Places of other steps are on what is left. */
        "Plan.leaflet_resection": {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            step: "leaflet_resection";
        } & (components["schemas"]["Plan.triangular_resection"] | components["schemas"]["Plan.quadrangular_resection"]);
        /** @description A wedge, as wide as told at the free edge. */
        "Plan.triangular_resection": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "leaflet_resection";
            /**
             * @description A wedge. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            shape: "triangular";
            /**
             * @description Leaflet that is cut.
             * @enum {string}
             */
            leaflet: "anterior" | "posterior";
            /** @description Its middle: 0 anterolateral commissure, 0.5 A2 or P2, 1 posteromedial commissure. */
            along: number;
            /** @description Along the free edge; of the anterior leaflet 10 at most. */
            width_mm: number;
            /** @description From the free edge, as a share of the way to the annulus. */
            height: number;
        };
        /** @description A strip of the posterior leaflet. */
        "Plan.quadrangular_resection": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "leaflet_resection";
            /**
             * @description A strip from the free edge to the annulus, of the posterior leaflet. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            shape: "quadrangular";
            /** @description Its middle: 0 anterolateral commissure, 0.5 P2, 1 posteromedial commissure. */
            along: number;
            /** @description At most a third of the posterior annulus; without sliding 15 at most. */
            width_mm: number;
            /** @description The rest of the leaflet is spread over the posterior annulus; if not, the annulus is gathered. */
            sliding: boolean;
        };
        /** @description A chorda moved to another point of the leaflets. */
        "Plan.chordal_transfer": {
            /**
             * @description Kind of step. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            step: "chordal_transfer";
            /** @description Id of the chorda. */
            chorda: string;
            /** @description Where all its insertions go. */
            insertion: components["schemas"]["Plan.leaflet_point"];
        };
        /** @description A suture that ties a papillary muscle to the annulus; the muscle moves until the suture is taut. */
        "Plan.papillary_approximation": {
            /**
             * @description discriminator enum property added by openapi-typescript
             * @enum {string}
             */
            step: "papillary_approximation";
        } & (components["schemas"]["Plan.approximation_to_landmark"] | components["schemas"]["Plan.approximation_to_point"]);
        /** @description Tied to a landmark of the annulus. */
        "Plan.approximation_to_landmark": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "papillary_approximation";
            /**
             * @description Papillary muscle that is tied.
             * @enum {string}
             */
            side: "anterolateral" | "posteromedial";
            /**
             * @description Where on the annulus: the trigone of its own side, or the saddle peak. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            anchor: "ipsilateral_trigone" | "saddle_peak";
            /** @description Length from the mean tip of the muscle to the anchor. */
            suture_length_mm: number;
        };
        /** @description Tied to any point of the annulus. */
        "Plan.approximation_to_point": {
            /**
             * @description Kind of step.
             * @constant
             */
            step: "papillary_approximation";
            /**
             * @description Papillary muscle that is tied.
             * @enum {string}
             */
            side: "anterolateral" | "posteromedial";
            /**
             * @description Where on the annulus: at annulus_around. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            anchor: "annulus_point";
            /** @description 0 posteromedial commissure, 0.25 saddle peak, 0.5 anterolateral commissure, 0.75 mid-posterior. */
            annulus_around: number;
            /** @description Length from the mean tip of the muscle to the anchor. */
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
             * @description More closures, as a share of `evaluations`, for plans that trade leak, opening and durability otherwise than the best; none where plans are not opened or the search was stopped early.
             * @default 0.3
             */
            front_share?: number;
            /**
             * @description Open plans in diastole, too, once they are closed at more than one node: opening area and mean gradient.
             * @default true
             */
            openings?: boolean;
            /**
             * @description Times that the mesh is refined, each triangle into four, for the verdict on each reported plan; 0: its own mesh.
             * @default 1
             */
            fine_levels?: number;
            /**
             * @description Draws of the model's own values (tissue, chordae), under which each reported plan is closed as planned: a rank that does not survive them is called a tie; 0: none.
             * @default 8
             */
            model_draws?: number;
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
        /** @description What every plan must have, what none may have, and what may be tied. */
        "Search.rules": {
            /** @description Steps that every plan has, as they are. */
            fixed?: {
                /**
                 * @description Format and version of the plan; may be left out.
                 * @constant
                 */
                schema?: "coapt.plan/1";
                steps: components["schemas"]["Plan"]["steps"];
            };
            /** @description Techniques that no plan has: annuloplasty, papillary_approximation, neochorda, chordal_length_change, chordal_excision, chordal_transfer, edge_to_edge, leaflet_resection; or, after a colon, one kind of it: annuloplasty:own, annuloplasty:<ring shape>, papillary_approximation:anterolateral, :posteromedial, :ipsilateral_trigone, :saddle_peak, :annulus_point, neochorda:anterior, :posterior, edge_to_edge:stitch, :clip, leaflet_resection:triangular, :quadrangular, :anterior, :posterior. */
            forbidden?: string[];
            /** @description Designed shapes of rings, offered beside those of the catalogue; their names may be forbidden, too. */
            shapes?: components["schemas"]["Plan.designed_shape"][];
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
             * @description Allows resection of the leaflet at a lesion.
             * @default false
             */
            leaflet_resection?: boolean;
            /**
             * @description Allows a clip at a lesion.
             * @default false
             */
            edge_to_edge?: boolean;
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
             * @description Per mmHg of mean gradient in diastole above 3.
             * @default 2
             */
            gradient_above_3?: number;
            /**
             * @description More, per mmHg above 5.
             * @default 10
             */
            gradient_above_5?: number;
            /**
             * @description Per mm of further disease that a reported plan does not last, of 12.
             * @default 0.25
             */
            durability?: number;
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
            /**
             * @description Kind of problem, for programs.
             * @enum {string}
             */
            code: "invalid_json" | "missing_field" | "unknown_field" | "wrong_type" | "out_of_range" | "bad_reference" | "bad_topology" | "bad_geometry" | "impossible_step" | "unsupported" | "input_output" | "busy" | "no_space";
            /** @description JSON pointer into the request's body; ?NAME: a parameter of the query; empty: the whole of the request. */
            path: string;
            /** @description What is wrong, and what is accepted. */
            message: string;
        };
        /** @description RFC 9457. */
        Problem: {
            /**
             * Format: uri
             * @description The kind of the first problem, as an address that leads nowhere: https://coapt.example/problems/ and its code.
             */
            type: string;
            /** @description The status in words. */
            title: string;
            /** @description HTTP status of this answer. */
            status: number;
            /** @description The first of the problems, or a general sentence. */
            detail: string;
            /** @description Every problem, not only the first. */
            problems: components["schemas"]["Fault"][];
            notice: components["schemas"]["Notice"];
        };
        /** @description A file: as text, or as base64 (binary PLY and STL). */
        FileToImport: {
            /** @description Its extension says its format: skirt.stl, annulus.mrk.json. */
            name: string;
            /** @description What is in it, if that is text; then without base64. */
            text?: string;
            /** @description Its bytes (RFC 4648); then without text. */
            base64?: string;
        };
        /** @description Either leaflets or labels, with chordae or chordae_seed, in one coordinate system and one unit, or slicerheart. */
        FilesToImport: {
            /** @description Sheets or thick shells, which become their mid-surfaces (OBJ, PLY, STL, VTK): the anterior, then the posterior leaflet, or one skirt. */
            leaflets?: [
            ] | [
                components["schemas"]["FileToImport"]
            ];
            /** @description Closed loop: CSV of x,y,z, or a closed curve of Slicer (.mrk.json). Left out: the annulus of the label map, else found at the leaflets' outer rim. */
            annulus?: components["schemas"]["FileToImport"];
            /** @description Insertions and papillary tips: CSV of id,papillary,ins_x,ins_y,ins_z,tip_x,tip_y,tip_z, or JSON. */
            chordae?: components["schemas"]["FileToImport"];
            /** @description Instead of chordae: they were not seen, and are drawn from anatomy. The same seed gives the same chordae; 0 the mean anatomy. */
            chordae_seed?: number;
            /** @description Papillary tips that were seen, of chordae that are drawn: CSV of papillary,x,y,z, papillary AL or PM, or points of Slicer labelled so (.mrk.json). Left out, they are drawn, too. */
            tips?: components["schemas"]["FileToImport"];
            /** @description Places that a person saw; those left out are found. */
            landmarks?: components["schemas"]["SeenLandmarks"];
            /** @description Whether the two leaflets were imaged closed, under pressure: the open ones are then derived from what is seen of them, with chordae_seed. Left out, it is judged from how much of the annulus they cover; a decision says it. */
            closed?: boolean;
            /**
             * @description Height of closed leaflets that coaptation hides.
             * @default 3
             */
            hidden_mm?: number;
            /** @description Instead of leaflets: a label map (.nrrd, .nii, .nii.gz, at most 67,108,864 voxels) of the leaflets as they were segmented and, perhaps, of the annulus. Of what the file holds besides geometry and labels nothing is kept. */
            labels?: components["schemas"]["FileToImport"];
            label_numbers?: components["schemas"]["LabelNumbers"];
            /**
             * @description Patient's axes of meshes and tables; left out: as each file's header says (SPACE=RAS of Slicer), else LPS. Markups and label maps say it themselves.
             * @enum {string}
             */
            frame?: "LPS" | "RAS";
            /** @description The files of a folder that SlicerHeart's ValveFemExport or coapt export wrote. */
            slicerheart?: components["schemas"]["FileToImport"][];
            /**
             * @description Of the valve.
             * @default imported
             */
            name?: string;
            /** @description Source or licence, a sentence each; kept in the valve. */
            provenance?: string[];
            /**
             * @description About how many triangles the valve is to have.
             * @default 720
             */
            triangles?: number;
            /**
             * @description Insertions of each marginal chorda.
             * @default 3
             */
            branches?: number;
            /**
             * @description Where a chorda branches, as a share of the way from its tip to its insertion.
             * @default 0.75
             */
            branch_at?: number;
            /**
             * @description Lengths of chordae over the straight distances.
             * @default 1
             */
            slack?: number;
            /**
             * @description What the meshes show: excised, leaflets free of stress; in_vivo, those of the unpressurised heart, which are stretched already.
             * @default excised
             * @enum {string}
             */
            reference?: "excised" | "in_vivo";
            /**
             * @description Of the files' lengths; left out, they are guessed from the circumference of the annulus (30 to 400 mm).
             * @enum {string}
             */
            units?: "mm" | "cm" | "m";
        };
        /** @description In the coordinates and the unit of the files, at most 10 mm from the annulus. Commissures count if both are given. */
        SeenLandmarks: {
            /** @description Where the leaflets meet, on the side of the anterolateral papillary muscle. */
            anterolateral_commissure?: components["schemas"]["Vector"];
            /** @description Where they meet on the other side. */
            posteromedial_commissure?: components["schemas"]["Vector"];
            /** @description Middle of the anterior annulus. */
            saddle_peak?: components["schemas"]["Vector"];
            /** @description Middle of the posterior annulus. */
            mid_posterior?: components["schemas"]["Vector"];
        };
        /** @description FilesToImport, and to what the valve is fitted. */
        FilesToFit: {
            leaflets?: components["schemas"]["FilesToImport"]["leaflets"];
            labels?: components["schemas"]["FilesToImport"]["labels"];
            label_numbers?: components["schemas"]["FilesToImport"]["label_numbers"];
            frame?: components["schemas"]["FilesToImport"]["frame"];
            annulus?: components["schemas"]["FilesToImport"]["annulus"];
            chordae?: components["schemas"]["FilesToImport"]["chordae"];
            chordae_seed?: components["schemas"]["FilesToImport"]["chordae_seed"];
            tips?: components["schemas"]["FilesToImport"]["tips"];
            landmarks?: components["schemas"]["FilesToImport"]["landmarks"];
            closed?: components["schemas"]["FilesToImport"]["closed"];
            hidden_mm?: components["schemas"]["FilesToImport"]["hidden_mm"];
            slicerheart?: components["schemas"]["FilesToImport"]["slicerheart"];
            name?: components["schemas"]["FilesToImport"]["name"];
            provenance?: components["schemas"]["FilesToImport"]["provenance"];
            triangles?: components["schemas"]["FilesToImport"]["triangles"];
            branches?: components["schemas"]["FilesToImport"]["branches"];
            branch_at?: components["schemas"]["FilesToImport"]["branch_at"];
            slack?: components["schemas"]["FilesToImport"]["slack"];
            reference?: components["schemas"]["FilesToImport"]["reference"];
            units?: components["schemas"]["FilesToImport"]["units"];
            /** @description Left out: the valve is not fitted. */
            fit?: components["schemas"]["Fit"];
        };
        /** @description What images do not show (lengths of chordae, papillary tips, prestretch, height in coaptation) is changed, within three standard deviations of what is assumed of it, until the valve closes onto the surface. */
        Fit: {
            /** @description The closed leaflets as imaged: a mesh, or points (CSV), in the coordinates and the unit of the other files. Left out: the leaflets themselves, which were imaged closed. */
            surface?: components["schemas"]["FileToImport"];
            /**
             * @description What the surface is: the leaflets' atrial side or their middle.
             * @default atrial
             * @enum {string}
             */
            side?: "atrial" | "middle";
            /** @description Regurgitant orifice as imaged: an anatomic area, not one by PISA. */
            leak_mm2?: number;
            /**
             * @description How well the leak is known.
             * @default 3
             */
            leak_sd_mm2?: number;
            /** @description What stays as it is. */
            known?: ("slack" | "tips" | "prestretch" | "hidden")[];
            /**
             * @description How well lengths of chordae are known before, share of the length.
             * @default 0.06
             */
            slack_sd?: number;
            /**
             * @description How well each coordinate of the papillary tips is known before.
             * @default 1
             */
            tip_sd_mm?: number;
            /**
             * @description How well the height hidden in coaptation is known before.
             * @default 1.5
             */
            hidden_sd_mm?: number;
            /**
             * @description Points used of the surface, at most.
             * @default 2000
             */
            points?: number;
            /**
             * @description Rounds of either pass, at most.
             * @default 30
             */
            rounds?: number;
        };
        FilesToLookAt: {
            /** @description Of any format that an import takes, in any order. */
            files: components["schemas"]["FileToImport"][];
        };
        FilesLookedAt: {
            /** @description One for each file. */
            files: components["schemas"]["FileLookedAt"][];
            notice: components["schemas"]["Notice"];
        };
        /** @description What a file holds, in its own coordinates and unit. */
        FileLookedAt: {
            /** @description As it was given. */
            name: string;
            /**
             * @description curve: a closed one; unknown: it cannot be read.
             * @enum {string}
             */
            content: "surface" | "labels" | "curve" | "points" | "tips" | "chordae" | "unknown";
            /** @description Of chordae: insertion, tip, insertion, tip, ... */
            points: components["schemas"]["FlatPoints"];
            /** @description Of a surface: three indices of points for each triangle, one after the other. */
            faces: number[];
            /** @description Of points, one each, or none; of tips and chordae AL or PM. */
            labels: string[];
            /** @description Why it cannot be read; else empty. */
            problems: components["schemas"]["Fault"][];
        };
        /** @description What an import has come to. */
        ImportResult: {
            /**
             * @description Name and version of this format.
             * @constant
             */
            schema: "coapt.import/1";
            /** @description Of coapt. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            /** @description Of the valve. */
            name: string;
            /** @description Number of triangles of the leaflets. */
            triangles: number;
            /** @description Number of chordae. */
            chordae: number;
            /** @description Measured, of leaflets that came as thick shells. */
            thickness?: {
                /** @description Which of the leaflets given, from 0. */
                leaflet?: number;
                /** @description Mean over the leaflet. */
                mean_mm?: number;
                /** @description A tenth of it is thinner. */
                p10_mm?: number;
                /** @description A tenth of it is thicker. */
                p90_mm?: number;
            }[];
            /** @description What the import and the fit settled, in this order. */
            decisions: components["schemas"]["ImportDecision"][];
            /** @description Id of the valve made: the fitted one if there was a fit. */
            valve: components["schemas"]["Id"];
            /** @description Id of the valve before the fit. */
            imported: components["schemas"]["Id"];
            /** @description How well the valve closes onto the surface; null: no fit was asked for. */
            fit: components["schemas"]["FitResult"] | null;
        };
        /** @description What a fit has found. */
        FitResult: {
            /**
             * @description Name and version of this format.
             * @constant
             */
            schema: "coapt.fit/1";
            /** @description Of coapt. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            /** @description Id of the valve that was fitted. */
            valve: components["schemas"]["Id"];
            /** @description What it was fitted to. */
            closed: string;
            /**
             * @description What the surface was taken as.
             * @enum {string}
             */
            side: "atrial" | "middle";
            /** @description Root mean square distance from the surface, fitted. */
            rms_mm: number;
            /** @description The same before the fit. */
            rms_before_mm: number;
            /** @description Points of the surface. */
            points: {
                /** @description Number given. */
                given: number;
                /** @description Number used. */
                used: number;
                /** @description As how many independent ones they weigh. */
                independent: number;
            };
            /** @description Leak of the valve. */
            leak_mm2: {
                /** @description Before the fit. */
                before: number;
                /** @description After it. */
                fitted: number;
                /** @description Standard deviation that the fit leaves it. */
                sd: number;
                /** @description As imaged, if that was given. */
                given?: number;
                /** @description How well that is known. */
                given_sd?: number;
            };
            /** @description What was fitted. */
            parameters: components["schemas"]["FittedParameter"][];
            /** @description Of the parameters with each other, a row each. */
            correlations: (number | null)[][];
            /** @description Rounds of both passes. */
            rounds: number;
            /** @description Closures made. */
            closures: number;
            /** @description Whether it came to rest before its limit of rounds, of time, or a cancellation. */
            finished: boolean;
            /**
             * @description Why it ended.
             * @enum {string}
             */
            stop?: "at_rest" | "round_limit" | "time_limit" | "cancelled";
        };
        /** @description One unknown of a fit. */
        FittedParameter: {
            /** @description slack_anterior_AL, tip_AL_x, circumferential_prestretch, hidden_mm, ... */
            name: string;
            /**
             * @description Of value, sd, prior and prior_sd.
             * @enum {string}
             */
            unit: "mm" | "1";
            /** @description As fitted. */
            value: number;
            /** @description How well it is known now: standard deviation. */
            sd: number;
            /** @description Before the fit. */
            prior: number;
            /** @description How well it was known before. */
            prior_sd: number;
            /** @description Whether the surface at least halves what was not known. */
            identifiable: boolean;
        };
        /** @description A valve that is stored now. */
        StoredValve: {
            id: components["schemas"]["Id"];
            /** @description Number of vertices of the leaflets. */
            vertices: number;
            /** @description Number of triangles of the leaflets. */
            triangles: number;
            /** @description Number of chordae, ruptured ones included. */
            chordae: number;
            /** @description What an import settled, in this order; only of valves:import. */
            decisions?: components["schemas"]["ImportDecision"][];
            notice: components["schemas"]["Notice"];
        };
        /** @description Which label of a label map is what; left out: by the names that the file gives its labels, else 1, 2 and 3. */
        LabelNumbers: {
            /** @description Label of the anterior leaflet. */
            anterior?: number;
            /** @description Label of the posterior leaflet. */
            posterior?: number;
            /** @description Label of the annulus, a closed band. */
            annulus?: number;
        };
        /** @description What an import settled that its files leave open, or changed. The valve's provenance says the same. */
        ImportDecision: {
            /** @description files, labels, series, axes, units, frame, anterior leaflet, posterior leaflet, skirt, annulus, state, mesh, commissures, landmarks, thickness, chordae or fit. */
            about: string;
            /** @description What was done, with numbers. */
            decision: string;
            /** @description Why, or by what rule. */
            reason: string;
            /** @description A person should check it against the images. */
            look: boolean;
        };
        /** @description Whether a document is a valve. */
        Validation: {
            /** @description Whether this service accepts it as a valve. */
            valid: boolean;
            /** @description Every problem that was found; empty if there is none. */
            problems: components["schemas"]["Fault"][];
            notice: components["schemas"]["Notice"];
        };
        Valves: {
            /** @description Stored valves, newest first. */
            valves: {
                /** @description Id of the valve. */
                valve: components["schemas"]["Id"];
                /** @description Name in its document. */
                name: string;
                /** @description Number of vertices of the leaflets. */
                vertices: number;
                /** @description Number of triangles of the leaflets. */
                triangles: number;
            }[];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        PlanToKeep: {
            /** @description Name for people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
            /** @description The id of a stored valve, or a preset's name. */
            valve: string;
            /** @description The plan; it must be possible on that valve. */
            plan: components["schemas"]["Plan"];
        };
        NewName: {
            /** @description Name for people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
        };
        KeptPlan: {
            /** @description Id of the kept plan. */
            kept_plan: components["schemas"]["Id"];
            /** @description Name for people to read: one line, at most 200 bytes of UTF-8. */
            name: string;
            /** @description The id of a stored valve, or a preset's name. */
            valve: string;
            /** @description The plan as it was kept. */
            plan: components["schemas"]["Plan"];
            notice?: components["schemas"]["Notice"];
        };
        KeptPlans: {
            /** @description Kept plans, newest first. */
            kept_plans: components["schemas"]["KeptPlan"][];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        /** @description Of a search: the best plan so far. One closed at more nodes comes before one closed at fewer. */
        LeadingPlan: {
            /** @description Cost in mm2 over its nodes; lower is better. */
            cost: number | null;
            /** @description How many nodes of the region of interest it was closed at. */
            nodes: number;
            /** @description Leak of the plan as planned; null: not known. */
            leak_mm2: number | null;
            description: components["schemas"]["RankedPlan"]["description"];
            /** @description The plan, ready for another request. */
            plan: components["schemas"]["Plan"];
        };
        Presets: {
            /** @description One entry for each preset. */
            presets: {
                /** @description Name of the preset; requests take it for the valve. */
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
            /** @description Ring shapes of the catalogue. */
            rings: {
                /** @description Name of the shape in a plan's step. */
                name: components["schemas"]["Plan.catalogue_ring"]["shape"];
                /** @description Anteroposterior depth over true transverse width. */
                ap_over_transverse: number;
                /** @description True transverse width over the labelled size. */
                transverse_factor: number;
                /** @description Height of the saddle over true transverse width; 0: flat. */
                saddle_over_transverse: number;
                /** @description The shape in words, and what was left out of it. */
                note: string;
            }[];
            /** @description Labelled transverse sizes. */
            sizes_mm: {
                /** @description Smallest labelled size. */
                min: number;
                /** @description Largest labelled size. */
                max: number;
                /** @description Difference between neighbouring sizes. */
                step: number;
            };
            notice: components["schemas"]["Notice"];
        };
        /** @description Figures of a closed valve. Null: the closure diverged, so nothing is known but the annulus. */
        Measure: {
            /** @description Area of the regurgitant orifice in the view from the atrium, leaflets with their half thickness. */
            orifice_area_mm2: number | null;
            /** @description Numerical error of orifice_area_mm2 (mesh, stopping early, other equilibria), which nine of ten measured scenes keep. Null: the closure is not converged uncrossed. */
            orifice_area_mm2_error: number | null;
            /** @description The same area with the leaflets as bare mid-surfaces. */
            orifice_area_raw_mm2: number | null;
            /** @description Mean of orifice_area_mm2 over closely spaced end states. */
            orifice_area_mean_mm2: number | null;
            /** @description The larger of orifice_area_mm2 and gap_area_mm2: what a competent valve keeps near zero. */
            leak_mm2: number | null;
            /** @description Numerical error of leak_mm2, as orifice_area_mm2_error. */
            leak_mm2_error: number | null;
            /** @description Connected openings in the view from the atrium, largest first. */
            orifices: {
                /** @description Area of this opening. */
                area_mm2: number;
                /** @description Centroid of this opening, on the annular plane. */
                centroid_mm: [
                    number,
                    number,
                    number
                ];
                /**
                 * @description Segment of the leaflet nearest to the centroid.
                 * @enum {string}
                 */
                segment: "A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC";
            }[];
            /** @description How the leaflets meet across the line of coaptation. */
            coaptation: {
                /** @description Smallest height of the nine sections. */
                height_min_mm: number | null;
                /** @description Mean height of the nine sections. */
                height_mean_mm: number | null;
                /** @description Tenth percentile of the heights of the nine sections. */
                height_p10_mm: number | null;
                /** @description Largest distance_mm of the nine sections; null also if one has no anterior tissue. */
                distance_max_mm: number | null;
                /** @description Opening between the leaflets in three dimensions, also where one hides it from the atrium: the smallest membrane from one to the other, along a line from commissure to commissure. */
                gap_area_mm2: number | null;
                /** @description Numerical error of gap_area_mm2, as orifice_area_mm2_error. */
                gap_area_mm2_error: number | null;
                /** @description Nine sections across the line of coaptation, from along 0.1 to 0.9. */
                sections: {
                    /** @description 0 at the anterolateral, 1 at the posteromedial commissure. */
                    along: number;
                    /** @description Coaptation height: length over which the leaflets are in contact. */
                    height_mm: number | null;
                    /** @description Smallest distance between the mid-surfaces; null also if there is no anterior tissue. */
                    distance_mm: number | null;
                    /** @description Whether the leaflets are in contact here. */
                    contact: boolean;
                }[];
            };
            /** @description Dimensions of the annulus under pressure. */
            annulus: {
                /** @description Anteroposterior: saddle peak to mid-posterior, projected on the plane of best fit. */
                ap_mm: number;
                /** @description Transverse: widest extent in the direction from commissure to commissure. */
                al_pm_mm: number;
                /** @description Length around, in three dimensions. */
                circumference_mm: number;
                /** @description Area, projected on the plane of best fit. */
                area_mm2: number;
                /** @description Height of the saddle: extent along the normal of that plane. */
                saddle_height_mm: number;
            };
            /** @description Distance from the annular line (saddle peak to mid-posterior) to the coaptation point; below 0 where leaflets billow. */
            tenting_height_mm: number | null;
            /** @description Area between the annular line and the leaflets in the mid-valve section; below 0 where leaflets billow. */
            tenting_area_mm2: number | null;
            /** @description Highest tension in a segment of a chorda. */
            tension_max_n: number | null;
            /** @description Sum of the tensions of the segments that leave a papillary head. */
            tension_sum_n: number | null;
            /** @description Green-Lagrange strain along the fibres, 99th percentile over triangles. */
            strain_circumferential_max: number | null;
            /** @description Green-Lagrange strain across the fibres, 99th percentile over triangles. */
            strain_radial_max: number | null;
        };
        /** @description coapt.closure/1, as `coapt close --json` prints it. */
        Closure: components["schemas"]["Measure"] & {
            /** @description Share of the closed leaflets' area that lies on the other side, nearer than 1.25 thicknesses; of mitral valves. */
            coaptation_area_index?: number | null;
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.closure/1";
            /** @description Version of coapt that closed the valve. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            /** @description Name of the valve. */
            valve: string;
            /** @description Number of triangles of the leaflets. */
            triangles: number;
            /**
             * @description Fast relaxation, or the method of the thesis; the service uses fast.
             * @enum {string}
             */
            method: "fast" | "thesis";
            /**
             * @description Model of the leaflets: springs, or orthotropic finite elements; the service uses continuum.
             * @enum {string}
             */
            membrane: "springs" | "continuum";
            /**
             * @description converged: at rest; step_limit: not yet at rest; diverged: unstable, there is no shape.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Force left at rest: rms free force / rms pressure force. */
            residual: number | null;
            /** @description Steps of all attempts. */
            steps: number;
            /** @description Time that closing took. */
            seconds: number;
            /** @description Whether leaflets pass through each other: then the figures do not count. */
            crossing: boolean;
            /** @description Pairs of triangles that pass through each other. */
            crossing_pairs: number;
            /** @description Attempts, from quick to careful, until one is converged and uncrossed. */
            attempts: {
                /** @description Name of the attempt, such as float, edge contact. */
                how: string;
                /**
                 * @description How this attempt ended.
                 * @enum {string}
                 */
                status: "converged" | "step_limit" | "diverged";
                /** @description Pairs of triangles that pass through each other after it. */
                crossing_pairs: number;
                /** @description Residual after this attempt. */
                residual: number | null;
                /** @description Steps of this attempt. */
                steps: number;
            }[];
            /** @description Rules of practice that the repair breaks, in words. */
            warnings: string[];
        };
        /** @description x, y, z, x, y, z, ... in mm, rounded to 0.001. */
        FlatPoints: number[];
        /** @description coapt.scene/1: all that is drawn of a closed valve. Indices count from 0. */
        Scene: {
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.scene/1";
            notice: components["schemas"]["Notice"];
            /** @description The annulus's plane of best fit: x posteromedial, y anterior, normal to the atrium. */
            plane: {
                /** @description Mean of the vertices of the annulus. */
                origin_mm: components["schemas"]["Vector"];
                /** @description Unit vector towards the posteromedial commissure. */
                x: components["schemas"]["Vector"];
                /** @description Unit vector towards the anterior side. */
                y: components["schemas"]["Vector"];
                /** @description Unit vector towards the atrium. */
                normal: components["schemas"]["Vector"];
            };
            /** @description Thickness of the leaflets. */
            thickness_mm: number;
            /** @description Vertices of the unstressed leaflets. */
            rest_mm: components["schemas"]["FlatPoints"];
            /** @description Vertices of the leaflets under pressure; null: the closure diverged. */
            closed_mm: components["schemas"]["FlatPoints"] | null;
            /** @description Vertex indices, three for each face. */
            faces: number[];
            /** @description Segment of each face. */
            segments: ("A1" | "A2" | "A3" | "P1" | "P2" | "P3" | "AC" | "PC")[];
            /** @description Place of each vertex on the leaflets. around: 0 at the posteromedial commissure, 0.25 at the saddle peak, 0.5 at the anterolateral commissure, 0.75 at mid-posterior. height: 0 at the annulus, 1 at the free edge. */
            leaflet_coordinates: {
                /** @description One for each vertex. */
                around: number[];
                /** @description One for each vertex. */
                height: number[];
            };
            /** @description Vertex indices of the annulus, in order. */
            annulus: number[];
            /** @description Places of these vertices under pressure. */
            annulus_mm: components["schemas"]["FlatPoints"];
            /** @description Vertex indices of the landmarks, by name. */
            landmarks: {
                [key: string]: number;
            };
            heads: components["schemas"]["SceneHeads"];
            chordae: components["schemas"]["SceneChordae"];
            /** @description Sutures of papillary approximation, each from the mean tip of a muscle to its anchor on the annulus. */
            sutures: {
                /**
                 * @description Papillary muscle that is tied.
                 * @enum {string}
                 */
                side: "anterolateral" | "posteromedial";
                /** @description Mean tip of the heads of that muscle. */
                tip_mm: components["schemas"]["Vector"];
                /** @description Anchor on the annulus. */
                anchor_mm: components["schemas"]["Vector"];
            }[];
            /** @description Ties of edge-to-edge repairs, each between two points of the leaflets. */
            ties: {
                /** @description Unique. */
                id: string;
                anterior: components["schemas"]["ScenePoint"];
                posterior: components["schemas"]["ScenePoint"];
                /** @description 0: slack. */
                tension_n: number;
            }[];
            /** @description Seams of leaflet resections, each from its end towards the annulus to the free edge. */
            seams: components["schemas"]["ScenePoint"][][];
            /** @description Green-Lagrange strain of each face; null: the closure diverged. */
            strain: {
                /** @description Along the fibres, one for each face. */
                circumferential: number[];
                /** @description Across the fibres, one for each face. */
                radial: number[];
            } | null;
            /** @description Openings in the view from the atrium, largest first: the line around each, then those around islands of tissue in it. Seen from the atrium they are the orifice; each point is as high as the tissue beside it, so a membrane across the lines lies where the valve is open. */
            orifices: {
                /** @description Area in the view from the atrium. */
                area_mm2: number;
                /** @description Closed lines, the outer one first. */
                contours_mm: components["schemas"]["FlatPoints"][];
            }[];
            /** @description The line along the anterior side, from the anterolateral to the posteromedial commissure, on which the leaflets are nearest to each other. Lines from it across to the posterior side span the gap; its area is the integral of the width. */
            gap: {
                /** @description On the line. */
                anterior_mm: components["schemas"]["Vector"];
                /** @description The nearest point of the posterior side's mid-surface. */
                posterior_mm: components["schemas"]["Vector"];
                /** @description Distance of the two less the leaflets' thickness; 0 where the leaflets touch. */
                width_mm: number;
            }[];
            /** @description 37 planes across the line between the commissures. */
            sections: {
                /** @description 0 at the anterolateral commissure, 1 at the posteromedial one. */
                along: number;
                /** @description Point of the plane, on the line between the commissures. */
                point_mm: components["schemas"]["Vector"];
                /** @description Unit normal of the plane, towards the posteromedial side. */
                normal: components["schemas"]["Vector"];
                /** @description Coaptation height: length over which the leaflets are in contact. */
                height_mm: number;
                /** @description Smallest between the leaflets' mid-surfaces; null without anterior tissue. */
                distance_mm: number | null;
                /** @description Whether the leaflets are in contact here. */
                contact: boolean;
                /** @description Where the leaflets' mid-surfaces are nearest to each other: on the anterior side, in the section, and on the posterior side; null without anterior tissue. */
                nearest_mm: [
                    components["schemas"]["Vector"],
                    components["schemas"]["Vector"]
                ] | null;
            }[];
            /** @description States on the way from open to closed, which is not that of real time: vertices, branch points of chordae, heads. */
            motion_mm: components["schemas"]["FlatPoints"][];
            /** @description What was measured of this closure. */
            closure: components["schemas"]["Closure"];
        };
        /** @description coapt.opening/1: a valve in diastole, as `coapt open --json` prints it, and what is drawn of it. Figures are null where the leaflets did not come to rest or cross. */
        Opening: {
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.opening/1";
            /** @description Version of coapt that opened the valve. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            /** @description Name of the valve. */
            name: string;
            /**
             * @description converged: at rest; step_limit: not yet at rest; diverged: unstable, there is no shape.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Whether leaflets pass through each other: then nothing is measured. */
            crossing: boolean;
            /** @description Of the narrowest passage of the open leaflets' funnel, less their half thickness. */
            opening_area_mm2: number | null;
            /** @description Of that passage below the annulus's centroid along the funnel's axis; 0: at the annulus. */
            passage_depth_mm: number | null;
            /** @description Of the funnel's axis from the normal of the annulus's plane. */
            funnel_tilt_deg: number | null;
            /** @description Open in the view from the atrium, leaflets with their half thickness. */
            projected_area_mm2: number | null;
            /** @description Of the annulus in diastole, in its plane. */
            annulus_area_mm2: number;
            /** @description Mean gradient at flow_ml_s by Gorlin's equation, of the smaller of passage and projected area; null: nothing is open, too. */
            gradient_mmhg: number | null;
            /** @description The same at flow_exercise_ml_s. */
            gradient_exercise_mmhg: number | null;
            /** @description Mean flow of filling at rest. */
            flow_ml_s: number;
            /** @description Mean flow of filling at exercise. */
            flow_exercise_ml_s: number;
            /** @description Of the atrium over the ventricle, on the whole of the leaflets. */
            pressure_mmhg: number;
            /** @description How far systole moves annulus and papillary tips: diastole has them that much further apart. */
            systole: {
                /** @description Share of its diastolic area that the annulus loses; 0 behind a ring. */
                annular_contraction: number;
                /** @description Share of their distance in diastole by which the papillary tips approach each other. */
                tip_approach: number;
            };
            /** @description Force left at rest: rms free force / rms pressure force. */
            residual: number | null;
            /** @description Steps of all attempts. */
            steps: number;
            /** @description Time that opening took. */
            seconds: number;
            /** @description Rules of practice that the repair breaks, in words. */
            warnings: string[];
            scene: components["schemas"]["OpeningScene"];
        };
        /** @description What is drawn of an open valve. Vertices, faces, heads and chordae are in the order of Scene. */
        OpeningScene: {
            /** @description Vertex indices, three for each face. */
            faces: number[];
            /** @description Vertices of the open leaflets; null: the opening diverged. */
            open_mm: components["schemas"]["FlatPoints"] | null;
            /** @description Places of the annulus's vertices in diastole. */
            annulus_mm: components["schemas"]["FlatPoints"];
            heads: components["schemas"]["SceneHeads"];
            chordae: components["schemas"]["SceneChordae"];
            /** @description Outline of the narrowest passage, closed: the leaflets' mid-surfaces in its plane, and their free edges where these lie above it. Empty where it was not measured. */
            passage_mm: components["schemas"]["FlatPoints"];
            /** @description States on the way from the unstressed leaflets to the open ones, evenly; not real time. Points of each: vertices, branch points of chordae, heads. Empty unless frames were asked for. */
            motion_mm: components["schemas"]["FlatPoints"][];
        };
        /** @description Heads of the papillary muscles. */
        SceneHeads: {
            /** @description Id in the valve's document. */
            id: string;
            /**
             * @description Papillary muscle to which it belongs.
             * @enum {string}
             */
            side: "anterolateral" | "posteromedial";
            /** @description Place in the unpressurised valve. */
            rest_mm: components["schemas"]["Vector"];
            /** @description Place under pressure. */
            tip_mm: components["schemas"]["Vector"];
        }[];
        /** @description Chordae under pressure, each a tree of segments. */
        SceneChordae: {
            /** @description Id in the valve's document; a repair names new ones neochorda-1, neochorda-2. */
            id: string;
            /**
             * @description Kind of chorda; neochorda: artificial.
             * @enum {string}
             */
            kind: "marginal" | "strut" | "basal" | "neochorda";
            /** @description Index into heads. */
            head: number;
            /** @description Whether it is ruptured or cut, and carries nothing. */
            ruptured: boolean;
            /** @description Segments from the head to the leaflet; they branch. */
            segments: {
                /** @description Segment at whose end it starts; -1: it starts at the head. */
                parent: number;
                /** @description Its far end: a branch point or a point of the leaflet. */
                end_mm: components["schemas"]["Vector"];
                /** @description Tension; 0 if it is slack or ruptured; null: the closure diverged. */
                tension_n: number | null;
                /** @description Index of the face into which it inserts; missing: it ends in a branch point. */
                face?: number;
                /** @description Weights of the face's vertices at the insertion; together 1. */
                weights?: components["schemas"]["Vector"];
            }[];
        }[];
        /** @description A point of the leaflets. */
        ScenePoint: {
            /** @description Index of the face that it lies in. */
            face: number;
            /** @description Of the three vertices of that face. */
            weights: [
                number,
                number,
                number
            ];
        };
        /** @description x, y and z; of a place in mm. */
        Vector: [
            number,
            number,
            number
        ];
        /** @description mm2, over the region of interest. Null: fewer than two of its nodes were closed, which says nothing of it. */
        Statistics: {
            /** @description Value of the plan as planned. */
            nominal: number | null;
            /** @description Mean over the region. */
            mean: number | null;
            /** @description Standard deviation over the region. */
            sd: number | null;
            /** @description Largest value in the region. */
            worst: number | null;
            /** @description 95th percentile over the region. */
            p95: number | null;
            /** @description Share of the region below 5 mm2. */
            below_5: number | null;
            /** @description Share of the region below 10 mm2. */
            below_10: number | null;
            /** @description Share of the region below 20 mm2. */
            below_20: number | null;
        };
        /** @description A ranked plan as it is compared; other members are not looked at. */
        ComparedPlan: {
            cost_terms: components["schemas"]["CostTerms"];
            /** @description In surgical words, a line a step. */
            description: string[];
            /** @description Of the plan. */
            leak_mm2?: {
                /** @description Over the region of interest. */
                mean: number | null;
            };
            /** @description In diastole. */
            opening_area_mm2?: number | null;
            /** @description Of further disease. */
            durability_mm?: number | null;
        };
        /** @description The plans of one search (coapt.plans/1) under a name; other members are not looked at. */
        PreferenceCase: {
            /**
             * @description What the plans are of.
             * @constant
             */
            schema: "coapt.plans/1";
            /** @description By which answers name it; each case has its own. */
            name: string;
            /** @description In the order of their ranks. */
            plans: components["schemas"]["ComparedPlan"][];
        };
        PreferenceAnswer: {
            /** @description Name of the case. */
            case: string;
            /** @description Place of a plan in its case, the first is 1. */
            first: number;
            /** @description Of another plan of that case. */
            second: number;
            /**
             * @description Which of them is preferred; unable: cannot tell.
             * @enum {unknown}
             */
            answer: "first" | "second" | "unable";
        };
        Preference: {
            /**
             * @description Name and version of this format.
             * @constant
             */
            schema: "coapt.preference/1";
            /** @description The two plans whose answer is expected to say most; null when all have been asked for. */
            question: {
                /** @description Name of the case. */
                case: string;
                /** @description Place of the plan shown first. */
                first: number;
                /** @description Place of the other plan. */
                second: number;
                /** @description An earlier question with sides swapped, one in ten: how consistent a rater is. */
                repeats: boolean;
                /** @description Expected of the answer, about the weights. */
                information_bits: number;
                /** @description rank, description and figures of both. */
                plans: [
                    Record<string, never>,
                    Record<string, never>
                ];
            } | null;
            /** @description Of each case the plan that is most likely the best for this expert. */
            first_places: {
                /** @description Name of the case. */
                case: string;
                /** @description Place in its case. */
                rank: number;
                /** @description That it is the best of its case. */
                probability: number;
            }[];
            /** @description What the answers say. */
            learned: components["schemas"]["LearnedWeights"];
            notice: components["schemas"]["Notice"];
        };
        /** @description coapt.weights/1, as coapt plan --weights takes it. */
        LearnedWeights: {
            /**
             * @description Name and version of this format.
             * @constant
             */
            schema: "coapt.weights/1";
            /** @description Of coapt. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            /** @description By name, as a search takes them; the most probable values. */
            weights: {
                [key: string]: number;
            };
            /** @description Of the expert's answers. */
            noise_mm2: number;
            /** @description How readily the expert cannot tell. */
            tie: number;
            /** @description Standard deviations of the natural logarithms, by name; 0.69 before any answer. */
            log_sd: {
                [key: string]: number;
            };
            /** @description Of the natural logarithms. */
            covariance: {
                /** @description Of rows and columns. */
                names: string[];
                /** @description Row by row. */
                matrix: number[][];
            };
            /** @description Weights of which the answers say something. */
            informed: string[];
            /** @description How many. */
            answers: number;
            /** @description Of these: cannot tell. */
            unable: number;
            /** @description Share of repeated questions answered alike; null without any. */
            consistency: number | null;
        };
        /** @description What a plan is ranked by: the sum of weights times these amounts is its cost, with what the finer mesh changes of it (an amount may be negative by that) and durability_price. With other weights plans are ranked anew without a closure. */
        CostTerms: {
            /** @description Steps. */
            step: number;
            /** @description Ring sizes by which the annulus is made smaller. */
            undersizing: number;
            /** @description Of these, above 4. */
            undersizing_above_4: number;
            /** @description Movement of both papillary muscles, mm. */
            movement: number;
            /** @description Of each, above 10 mm. */
            movement_above_10: number;
            /** @description Mean of the leak + weights.sd_share x its sd, mm2. */
            leak: number;
            /** @description Of this, above 1 mm2. */
            incompetence: number;
            /** @description 0 to 1: how near the first disturbance is that leaks. */
            margin: number;
            /** @description Mean of what A2 with P2 falls short of 8 mm. */
            coaptation: number;
            /** @description Mean of how much further apart leaflets are than they are thick, mm. */
            gap: number;
            /** @description Mean of peak chordal tension above the unrepaired valve's, N. */
            tension: number;
            /** @description Mean gradient above 3 mmHg. */
            gradient_above_3: number;
            /** @description Mean gradient above 5 mmHg. */
            gradient_above_5: number;
            /** @description Of 12 mm of further disease, those that the plan does not last; 0 without the evidence. */
            durability: number;
            /** @description Share of the closures that failed; 2 if all did. */
            untrusted: number;
        };
        /** @description A plan with its evidence, ranked against others. */
        RankedPlan: {
            /** @description Place among the ranked plans; 1 is the best. */
            rank: number;
            /** @description The plan, ready for another request. */
            plan: components["schemas"]["Plan"];
            /** @description The plan in surgical words, a line a step. */
            description: string[];
            /** @description Orifice over the region of interest. */
            orifice_area_mm2: components["schemas"]["Statistics"];
            /** @description Leak, the larger of orifice and gap, over the region of interest. */
            leak_mm2: components["schemas"]["Statistics"];
            /** @description Cost in mm2 over the region; lower is better. */
            cost: number | null;
            /** @description What it is ranked by. */
            cost_terms: components["schemas"]["CostTerms"];
            /**
             * @description How the closure of the plan as planned ended.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Whether leaflets pass through each other in that closure. */
            crossing: boolean;
            /** @description What was measured of the plan as planned. */
            measure: components["schemas"]["Measure"];
            /** @description Number of surgical steps. */
            steps: number;
            /** @description Undersizing of the annulus in ring sizes of 2 mm; 0 if it was left as it is. */
            ring_sizes_below: number;
            /** @description How far the anterolateral papillary muscle is moved. */
            anterolateral_movement_mm: number;
            /** @description How far the posteromedial papillary muscle is moved. */
            posteromedial_movement_mm: number;
            /** @description How many nodes of the region were closed. */
            region_closures: number;
            /** @description How many closures over the region did not converge or crossed. */
            region_failures: number;
            /** @description How much error it takes until the valve leaks more than 1 mm2 or a closure fails; 0 if it does as planned. */
            margin_to_leak: {
                /** @description Error of suture length, longer or shorter; 1 if none in the region leaks; null: not closed. */
                suture_length_mm: number | null;
                /** @description Error of angle, outwards or backwards; 5 if none in the region leaks; null: not closed. */
                angle_deg: number | null;
                /** @description Share of the way to the region's border, in any direction; 1 if no node leaks; null: not closed. */
                share: number | null;
            };
            /** @description Narrowest passage of the repaired valve, opened in diastole; null if it was not opened or did not come to rest. */
            opening_area_mm2: number | null;
            /** @description What is open in diastole along the annulus's normal; null likewise. */
            projected_area_mm2: number | null;
            /** @description Mean gradient at rest through the smaller of both (Gorlin, 155 ml/s); null likewise. */
            gradient_mmhg: number | null;
            /** @description At 1.4 times the flow; null likewise. */
            gradient_exercise_mmhg: number | null;
            /** @description How far disease may go on, way of the posteromedial tip, until the leak passes 5 mm2: mean over eight courses, those that do not come to it counted as 12; null without the evidence. */
            durability_mm: number | null;
            /** @description Share of these courses in which 12 mm are not enough; null without the evidence. */
            outlasting: number | null;
            /** @description What the plan is ranked by besides its cost: weights.durability for each mm of 12 that it does not last. */
            durability_price: number;
            /** @description Pareto-optimal among the ranked plans in mean + sd of the leak, opening and durability, to a tenth of mm2, cm2 and mm; the price of the operation decides between plans that are alike. */
            pareto: boolean;
            /** @description Probability that it is truly better than the next plan; null for the last one or without a region. */
            probability_outranks_next: number | null;
            /** @description Share of the draws of the model in which it is better than the next plan, too, as planned; null for the last one, without draws, or if no draw has both closed. */
            share_of_draws_ahead: number | null;
            /** @description Whether that probability is between 0.05 and 0.95, or that share is known and at most 0.95: the rank does not survive draws of the model. */
            tie_with_next: boolean;
            /** @description Nodes by which the plan was chosen for ranking. */
            subset: {
                /** @description How many nodes, at most 17. */
                nodes: number;
                /** @description Cost in mm2 over these nodes. */
                cost: number | null;
            };
            /** @description All closures over the region converged uncrossed, mean + sd of the leak are below 1 mm2, and so is the leak on the refined mesh. */
            closes_robustly: boolean;
            /** @description The plan as planned, closed on the refined mesh; null: none was asked for or possible, or the search was cancelled before. */
            fine: components["schemas"]["FineClosure"] | null;
            /** @description The plan as planned, closed under draws of the model's own values, the same for all plans; null: none were asked for, or the search was cancelled before. */
            under_draws: components["schemas"]["UnderDraws"] | null;
            /** @description A sample of the region's nodes, closed again from the open state; null: no evidence was asked for, or the search was cancelled before. */
            cold_starts: components["schemas"]["ColdStarts"] | null;
            /** @description Leak against suture length and angle: of both muscles, then of each sutured one alone if that was closed. */
            leak_map: {
                /**
                 * @description Which muscle is disturbed.
                 * @enum {string}
                 */
                muscle: "both" | "anterolateral" | "posteromedial";
                /** @description Error of suture length in each row. */
                suture_length_mm: number[];
                /** @description Swing outwards in each column. */
                outwards_deg: number[];
                /** @description Rows by length, columns by angle; null: not closed, or the closure failed. */
                leak_mm2: (number | null)[][];
            }[];
            /** @description Shares of the leak's variance over the region; null unless all 1,089 nodes were closed and the leak varies. */
            sobol: {
                /** @description Share of each error alone (first-order Sobol index). */
                first: {
                    /** @description Share of suture length. */
                    suture_length: number | null;
                    /** @description Share of the swing outwards. */
                    outwards: number | null;
                    /** @description Share of the swing backwards. */
                    posterior: number | null;
                };
                /** @description Share of each error with its interactions (total Sobol index). */
                total: {
                    /** @description Share of suture length. */
                    suture_length: number | null;
                    /** @description Share of the swing outwards. */
                    outwards: number | null;
                    /** @description Share of the swing backwards. */
                    posterior: number | null;
                };
            };
            /** @description Leak if all that is done errs by itself: each muscle within the region; a ring up to 1.5 mm off in its plane in either direction and turned by up to 5 degrees, one of its twelve sutures torn out in a quarter of the cases; neochordae up to 1 mm too short or long. 65 closures; null without the evidence. */
            independent_leak_mm2: components["schemas"]["Statistics"];
            /** @description Leak while the ventricle goes on remodelling; empty unless evidence was asked for. */
            remodelling: {
                /** @description Where both papillary tips go: apical, outwards, posterior, or all three. */
                direction: string;
                /** @description Leak at 0, 1, ... 6 mm; null: not closed, or the closure failed. */
                leak_mm2: (number | null)[];
            }[];
            /** @description Sixteen rules of practice. */
            gates: {
                /** @description Short name of the rule, such as papillary_movement. */
                rule: string;
                /**
                 * @description What the rule says of the plan; not_assessed: coapt cannot tell.
                 * @enum {string}
                 */
                severity: "pass" | "warn" | "reject" | "not_assessed";
                /** @description What was found, with its figure. */
                finding: string;
                /** @description Where the rule comes from. */
                source: string;
            }[];
            /** @description What speaks against the plan, in words. */
            warnings: string[];
            notice?: components["schemas"]["Notice"];
        };
        /** @description The valve as it is. */
        Before: components["schemas"]["Measure"] & {
            /** @description Narrowest passage in diastole; null if it was not opened or did not come to rest. */
            opening_area_mm2?: number | null;
            /** @description What is open in diastole along the annulus's normal; null likewise. */
            projected_area_mm2?: number | null;
            /** @description Mean gradient at rest through the smaller of both (Gorlin, 155 ml/s); null likewise. */
            gradient_mmhg?: number | null;
            /** @description At 1.4 times the flow; null likewise. */
            gradient_exercise_mmhg?: number | null;
            /**
             * @description How the closure of the valve as it is ended.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Whether leaflets pass through each other in that closure. */
            crossing: boolean;
        };
        /** @description A closure on a mesh whose triangles were each cut into four, once or twice. */
        FineClosure: {
            /** @description Of the refined mesh. */
            triangles: number;
            /**
             * @description How the closure ended.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Whether leaflets pass through each other. */
            crossing: boolean;
            /** @description Orifice on the refined mesh. */
            orifice_area_mm2: number | null;
            /** @description Gap on the refined mesh. */
            gap_area_mm2: number | null;
            /** @description The larger of both. */
            leak_mm2: number | null;
            /** @description Numerical error of this leak; null: the closure is not converged uncrossed. */
            leak_mm2_error: number | null;
            /** @description Cost of the plan with this closure as planned in place of its own: what plans are ranked by. */
            cost: number;
            /** @description Place of the plan by the valve's own mesh alone; another than its rank: the finer mesh changed the order. Null: not all plans were closed on the refined mesh, which then does not order them. */
            own_mesh_rank: number | null;
        };
        /** @description A leak when tissue and chordae vary within what their sources allow. */
        UnderDraws: {
            /** @description How many of the closures did not converge or crossed; they are left out. */
            failures: number;
            /** @description Over the draws; null where none is left. */
            leak_mm2: {
                /** @description Mean over the draws. */
                mean: number | null;
                /** @description Standard deviation: the model's own error of the leak. */
                sd: number | null;
                /** @description Largest of the draws. */
                worst: number | null;
            };
        };
        /** @description Whether closures over the region end where they do because of what they start from: the plan's other closures. */
        ColdStarts: {
            /** @description How many nodes were closed both ways, converged and uncrossed. */
            closures: number;
            /** @description How many of these end more than 0.1 mm (rms) elsewhere from the open state. */
            elsewhere: number;
            /** @description Largest difference of their leaks. */
            leak_difference_max_mm2: number;
        };
        /** @description coapt.plans/1, as `coapt plan --json` prints it. */
        Plans: {
            /**
             * @description Format and version of this document.
             * @constant
             */
            schema: "coapt.plans/1";
            /** @description Version of coapt that searched. */
            version: string;
            revision?: components["schemas"]["Revision"];
            notice: components["schemas"]["Notice"];
            before: components["schemas"]["Before"];
            /** @description Whether a plan closes the valve also when the surgeon's hand varies. */
            any_competent: boolean;
            /** @description Ranked plans, best first. */
            plans: components["schemas"]["RankedPlan"][];
            /** @description The mesh that verdicts on reported plans are of, besides the valve's own. */
            fine_mesh: {
                /** @description Times that each triangle was cut into four; fewer than asked for where the mesh would be too fine. */
                levels: number;
                /** @description Of that mesh; null without levels. */
                triangles: number | null;
                /** @description Of the valve as it is, on that mesh. */
                leak_before_mm2: number | null;
                /** @description Number of closures on refined meshes; closures does not count them. */
                closures: number;
            };
            /** @description Draws of the model's own values under which reported plans are closed, as planned. */
            model_draws: {
                /** @description How many; 0: none. */
                draws: number;
                /** @description The valve as it is under them; null without. */
                before: components["schemas"]["UnderDraws"] | null;
                /** @description Number of closures under draws; closures does not count them. */
                closures: number;
                /** @description Each draw has chordae of its own, because the valve's were never seen (drawn_chordae). */
                chordae_drawn: boolean;
                /** @description Each draw has other values of what a fit left uncertain (fit). */
                fit_drawn: boolean;
            };
            /** @description The costs of progress. */
            best_cost_history: (number | null)[];
            /** @description Lowest cost that the search had found, with each plan closed once. */
            progress: {
                /** @description After so many closures. */
                closures: number;
                /** @description Lowest cost by then, mm2. */
                cost: number | null;
            }[];
            /** @description Lowest cost that trying plans at random is expected to reach, in the same terms. */
            random_progress: {
                /** @description After so many closures. */
                closures: number;
                /** @description Lowest cost expected by then, mm2. */
                cost: number | null;
            }[];
            /** @description Plans that no other one known as well beats in mean + sd of the leak, opening and durability, to the digits printed, cheapest first. Where plans were not opened, the price of the operation stands for the opening. */
            pareto_front: {
                /** @description The plan, ready for another request. */
                plan: components["schemas"]["Plan"];
                /** @description The plan in surgical words, a line a step. */
                description: string[];
                /** @description Mean of the leak over its nodes. */
                mean_mm2: number | null;
                /** @description Standard deviation of the leak over its nodes. */
                sd_mm2: number | null;
                /** @description Number of surgical steps. */
                steps: number;
                /** @description Undersizing of the annulus in ring sizes of 2 mm. */
                ring_sizes_below: number;
                /** @description The smaller of both areas in diastole; null if it was not opened. */
                opening_mm2: number | null;
                /** @description Further disease that the repair bears, 0 to 12 mm; null where it is not known. */
                durability_mm: number | null;
                /** @description By the weights, with the price of what it does not last, mm2. */
                cost: number | null;
                /** @description How many nodes of the region of interest it was closed at. */
                nodes: number;
            }[];
            /** @description How well costs from few nodes rank plans as costs from more nodes do. */
            ladder: {
                /** @description Nodes of the cheaper cost; 0: geometry alone, nothing closed. */
                from: number;
                /** @description Nodes of the dearer cost. */
                to: number;
                /** @description Number of plans that were compared. */
                plans: number;
                /** @description Rank correlation of the two costs; null: not measured. */
                spearman: number | null;
                /** @description Whether it is below 0.8: then the cheaper cost alone does not rule plans out. */
                skipped: boolean;
            }[];
            /** @description Number of combinations of techniques that the search could try. */
            branches: number;
            /** @description Plans and techniques that the search left out. */
            cut: {
                /** @description Plans or techniques. */
                what: string;
                /** @description Why it was left out. */
                why: string;
            }[];
            /** @description Number of plans that the search could try. */
            plans_possible: number;
            /** @description Number of plans that were closed at least once. */
            plans_tried: number;
            /**
             * @description Why the search ended; exhausted: no plan was left that could be better.
             * @enum {string}
             */
            stop: "evaluation_limit" | "exhausted" | "no_improvement" | "target_reached" | "time_limit" | "cancelled";
            /** @description Number of closures, known ones included. */
            closures: number;
            /** @description Closures of the search itself: neither of the valve as it is nor of what plans trade nor of ranking. */
            evaluations: number;
            /** @description Number of closures known from an earlier run. */
            closures_known: number;
            /** @description Number of closures that did not converge. */
            closures_not_converged: number;
            /** @description Number of closures in which leaflets pass through each other. */
            closures_crossed: number;
            /** @description Time that search and ranking took. */
            seconds: number;
            /** @description What the model leaves out, in sentences. */
            not_modelled: string[];
            weights: components["schemas"]["Search"]["weights"];
            /** @description Input that gives the same plans again. */
            reproduce: {
                /** @description Hash of the valve, the options of its closure and the version. */
                valve_hash: string;
                /** @description Version of coapt that searched. */
                version: string;
                revision?: components["schemas"]["Revision"];
                /** @description Seed of the search. */
                seed: number;
                /** @description Empty: a request has none. */
                command: string;
                /** @description All options of the search, defaults included. */
                search: components["schemas"]["Search"];
            };
        };
        PlansToScore: {
            valve: components["schemas"]["ValveSource"];
            /** @description Plans to score. */
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
             * @description Also errors of single sutures and further remodelling: 88 to 308 closures more for each plan.
             * @default false
             */
            evidence?: boolean;
        };
        Evaluations: {
            /** @description Version of coapt that scored the plans. */
            version: string;
            revision?: components["schemas"]["Revision"];
            before: components["schemas"]["Before"];
            /** @description The plans in the order asked, each with its rank. */
            plans: (components["schemas"]["RankedPlan"] & {
                /** @description Place in the request, from 0. */
                index: number;
            })[];
            any_competent: components["schemas"]["Plans"]["any_competent"];
            ladder: components["schemas"]["Plans"]["ladder"];
            /** @description Number of different plans. */
            plans_tried: number;
            /** @description Number of closures, that of the valve as it is included. */
            closures: number;
            /** @description Number of closures that did not converge. */
            closures_not_converged: number;
            /** @description Number of closures in which leaflets pass through each other. */
            closures_crossed: number;
            /** @description Time that scoring took. */
            seconds: number;
            /** @description What the model leaves out, in sentences. */
            not_modelled: string[];
            notice: components["schemas"]["Notice"];
        };
        Study: components["schemas"]["GeometryStudy"] | components["schemas"]["AnchorStudy"];
        /** @description How the orifice depends on the geometry of the valve. */
        GeometryStudy: {
            /**
             * @description Geometry to vary: the annulus, the papillary tips, or these tips under undersized rings. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            name: "annulus" | "papillary" | "ring";
        };
        /** @description Papillary approximation to the trigone and to the saddle peak, compared over the region of interest. */
        AnchorStudy: {
            /**
             * @description approximation: that alone; thesis: the studies of geometry as well. (enum property replaced by openapi-typescript)
             * @enum {string}
             */
            name: "approximation" | "thesis";
            /**
             * @description Whether positions are looked up in a grid of closures or closed; optimum: also at each anchor's best suture.
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
             * @description Step between the displacements to repair, 0 to 6 mm; 1 if left out.
             * @enum {number}
             */
            displacement_step_mm?: 1 | 2 | 3 | 6;
            /** @description Nodes of the region of interest; all 1,089 if left out. */
            region_points?: number;
            /** @description Anchors around the annulus to compare with; if left out 24, none in thesis. */
            scan_sites?: number;
        };
        StudyResult: {
            /** @description Name of the study. */
            study: string;
            /** @description Name of the valve. */
            valve: string;
            /** @description Version of coapt that ran the study. */
            version: string;
            revision?: components["schemas"]["Revision"];
            /** @description Number of geometries. */
            configurations: number;
            /** @description Number of closures, those of earlier runs included. */
            closures: number;
            /** @description How many of them were known, from earlier runs or other studies of this valve. */
            closures_known: number;
            /** @description How many configurations did not converge or crossed. */
            untrusted: number;
            /** @description A sample of the configurations, closed again from the open state; its leaks are orifices. */
            cold_starts: components["schemas"]["ColdStarts"];
            /** @description Time that the study ran. */
            seconds: number;
            /** @description Findings of the thesis beside those on this valve. */
            findings: {
                /** @description Name of the finding, such as dilation-grows-superlinearly. */
                finding: string;
                /** @description Section of the thesis. */
                section: string;
                /** @description What the thesis says. */
                thesis: string;
                /** @description What this valve shows, in numbers. */
                ours: string;
                /** @description When the two count as agreeing. */
                judged: string;
                /** @description Whether they agree. */
                agrees: boolean;
            }[];
            /** @description Number of findings that agree with the thesis. */
            agree: number;
            notice: components["schemas"]["Notice"];
        };
        /**
         * @description QUEUED, RUNNING, then one of the others.
         * @enum {string}
         */
        JobState: "QUEUED" | "RUNNING" | "SUCCEEDED" | "FAILED" | "CANCELLED";
        /** @description How far a job is. */
        Progress: {
            /** @description Present stage: starting, searching, ranking, a part of the study, importing or fitting. */
            stage: string;
            /** @description Closures so far: of a search of any kind, known ones included; of a study made in its present stage; of an import in its fit. */
            closures: number;
            /** @description Closures planned: of a search at most, of a study in its present stage; 0: not known yet. */
            closures_planned: number;
            /** @description Smallest leak of a plan as planned, so far; null: none yet, or no search. */
            best_leak_mm2: number | null;
            /** @description Lowest cost of a search at one closure a plan, so far, mm2; null: none yet, or no search. */
            best_cost: number | null;
            /** @description Cost in mm2 that trying plans at random is expected to reach in as many closures; null until some were tried. */
            random_cost: number | null;
            /** @description Time of running, over all attempts. */
            seconds: number;
            /** @description Of a fit: root mean square distance from the surface, so far. */
            rms_mm?: number;
            best?: components["schemas"]["LeadingPlan"];
        };
        PlanSummary: {
            /** @description Place among the ranked plans; 1 is the best. */
            rank: number;
            description: components["schemas"]["RankedPlan"]["description"];
            /** @description The plan, ready for another request. */
            plan: components["schemas"]["Plan"];
            /** @description Orifice over the region of interest. */
            orifice_area_mm2: components["schemas"]["Statistics"];
            /** @description Leak, the larger of orifice and gap, over the region of interest. */
            leak_mm2: components["schemas"]["Statistics"];
            /** @description Cost in mm2 over the region; lower is better. */
            cost: number | null;
            /**
             * @description How the closure of the plan as planned ended.
             * @enum {string}
             */
            status: "converged" | "step_limit" | "diverged";
            /** @description Whether leaflets pass through each other in that closure. */
            crossing: boolean;
            margin_to_leak: components["schemas"]["RankedPlan"]["margin_to_leak"];
            /** @description Whether it is uncertain that it is better than the next plan. */
            tie_with_next: boolean;
            warnings: components["schemas"]["RankedPlan"]["warnings"];
        };
        /** @description A search, a study or an import. */
        Job: {
            /** @description Id of the job. */
            id: components["schemas"]["Id"];
            /**
             * @description plans: a search; study: a study; import: a valve made of files.
             * @enum {string}
             */
            kind: "plans" | "study" | "import";
            state: components["schemas"]["JobState"];
            /** @description When it was asked for. */
            created: components["schemas"]["Time"];
            /** @description When it first ran; null: not yet. */
            started: components["schemas"]["Time"] | null;
            /** @description When it ended; null: not yet. */
            finished: components["schemas"]["Time"] | null;
            /** @description Id of its valve, also if a preset was asked for; of an import as it was before the fit. */
            valve: components["schemas"]["Id"];
            /** @description Whether somebody asked to end it early. */
            cancel_requested: boolean;
            /** @description Why a running job stands still: nothing can be stored now. It goes on by itself. */
            waiting_for: string | null;
            /** @description Jobs before it; null: it does not wait. */
            queue_position: number | null;
            progress: components["schemas"]["Progress"];
            /** @description Why a job failed; else empty. */
            problems: components["schemas"]["Fault"][];
            /** @description Plans of a search, best first; null: it has not ended. A page of jobs leaves it out. */
            plans?: components["schemas"]["PlanSummary"][] | null;
            stop?: components["schemas"]["Plans"]["stop"];
            /** @description Whether a search that has ended found a plan that closes the valve also when the surgeon's hand varies. */
            any_competent?: boolean;
            /** @description Number of findings of a study that has ended. */
            findings?: number;
            /** @description Number of findings of a study that agree with the thesis. */
            agree?: number;
            /** @description Id of the valve that an import has made: the fitted one if there was a fit. */
            made?: components["schemas"]["Id"];
            /** @description Paths. Those of results once there are some; plans and evaluations only of a search, picture only of an import, report not of one. */
            links: {
                /**
                 * Format: uri-reference
                 * @description Path of this job.
                 */
                self: string;
                /**
                 * Format: uri-reference
                 * @description Path of its events.
                 */
                events: string;
                /**
                 * Format: uri-reference
                 * @description Path to POST to, to end it early.
                 */
                cancel: string;
                /**
                 * Format: uri-reference
                 * @description Path of all that it has found.
                 */
                result?: string;
                /**
                 * Format: uri-reference
                 * @description Path of its ranked plans.
                 */
                plans?: string;
                /**
                 * Format: uri-reference
                 * @description Path of every plan that was tried, as CSV.
                 */
                evaluations?: string;
                /**
                 * Format: uri-reference
                 * @description Path of an import's picture, as PNG: what was given beside the valve made of it.
                 */
                picture?: string;
                /**
                 * Format: uri-reference
                 * @description Path of its report, as HTML.
                 */
                report?: string;
                /**
                 * Format: uri-reference
                 * @description Path of the list of its files.
                 */
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
            /** @description Plans by rank. */
            plans: components["schemas"]["RankedPlan"][];
            next_page_token: components["schemas"]["NextPageToken"];
            notice: components["schemas"]["Notice"];
        };
        Files: {
            /** @description Files that the job has left. */
            files: {
                /** @description Name of the file. */
                name: string;
                /** @description Media type of the file. */
                type: string;
                /** @description Size of the file. */
                bytes: number;
                /**
                 * Format: uri-reference
                 * @description Path that answers the file.
                 */
                path: string;
            }[];
            notice: components["schemas"]["Notice"];
        };
        Live: {
            /**
             * @description The process answers.
             * @constant
             */
            status: "live";
            notice: components["schemas"]["Notice"];
        };
        Farm: {
            /** @description Those that are open, and the newest of the others. */
            runs: components["schemas"]["FarmRun"][];
            /** @description Those of the last day. */
            workers: components["schemas"]["FarmWorker"][];
            notice: components["schemas"]["Notice"];
        };
        /** @description Work that was asked for once: a batch of closures, searches of several valves. */
        FarmRun: {
            /** @description Its number in the farm. */
            run: number;
            /** @description What it is for, in words. */
            label: string;
            /** @description What an item is: "orifices", "plans", ... */
            kind: string;
            /**
             * @description holes: some items could not be computed, all others are.
             * @enum {string}
             */
            state: "open" | "done" | "holes" | "cancelled";
            /**
             * Format: date-time
             * @description When it was asked for, by the database's clock.
             */
            created: string;
            /** @description Number of items. */
            items: number;
            /** @description Number of items that are settled. */
            done: number;
            /** @description Items a second in the last minute. */
            rate_per_s: number;
            /** @description Seconds left at that rate; null: not known, or it has ended. */
            eta_s: number | null;
            /** @description Number of live workers that may compute it. */
            workers: number;
            /** @description It is open, and no live worker is of the same coapt. */
            waits_for_workers: boolean;
            /** @description Number of its tasks that were given up. */
            tasks_poison: number;
            /** @description Number of its tasks that workers answered in different ways: others compute them again. */
            tasks_disputed: number;
        };
        /** @description A program that computes items. */
        FarmWorker: {
            /** @description As it calls itself. */
            name: string;
            /** @description It was heard of within its lease. */
            alive: boolean;
            /** @description Its answers differed from those of two others: it gets no more work. */
            barred: boolean;
            /** @description Number of items that it has computed. */
            items: number;
            /** @description Items a second in the last minute. */
            rate_per_s: number;
            /** @description Seconds since it was heard of. */
            seen_s: number;
        };
        Ready: {
            /**
             * @description The service takes work.
             * @constant
             */
            status: "ready";
            /** @description Time that closing a small valve took just now. */
            closure_ms: number;
            /** @description Number of jobs that wait. */
            jobs_queued: number;
            /** @description Number of jobs that run. */
            jobs_running: number;
            notice: components["schemas"]["Notice"];
        };
        /** @description Of the program that answered; missing in results that release 0.1 has kept. */
        Revision: {
            /** @description The commit; `+changes` after it if files differed from it, `unknown` if nobody told the build. */
            git: string;
            /** @description Raised whenever a closure or its orifice comes out otherwise. */
            closures: number;
            /** @description Raised whenever a plan on the same closures comes out otherwise. */
            plans: number;
        };
        Version: {
            /**
             * @description Name of the program.
             * @constant
             */
            name: "coapt-server";
            /** @description Version of coapt. */
            version: string;
            revision?: components["schemas"]["Revision"];
            /**
             * @description Version of the API, the first part of its paths.
             * @constant
             */
            api: "v1";
            /** @description It hands jobs to a farm: see /v1/farm. */
            farm: boolean;
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
