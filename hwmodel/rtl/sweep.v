// The control of an arc's sweep: quadrant, crossings still to come, and the two end counters.
//
// The end counters hold the signed distance to the end point and count with every pulse. Before
// the last quadrant they stop nothing; in it, an axis whose counter is zero or has run through
// stands. When both stand, or one stands on a coordinate axis where it would feed the other
// nothing for ever, what is left is stepped out, a pulse a cycle on each axis.
//
// Once a cycle the engine has it look where the arc is: a quadrant that has been run through is
// left, and what the cycle needs to know of counters, coordinates and quadrant is put into
// flip-flops. So the zero detectors have a clock for themselves, and the adders have the next.
module sweep #(
    parameter N = 24
) (
    input  wire           i_clk,
    input  wire           i_rst,
    // command: the registers' first contents
    input  wire           i_load,
    input  wire [1:0]     i_quadrant,
    input  wire [2:0]     i_crossings,
    input  wire           i_cw,
    input  wire [N+1:0]   i_jex,
    input  wire [N+1:0]   i_jey,
    // look: which coordinates are zero
    input  wire           i_look,
    input  wire           i_x_is_zero,
    input  wire           i_y_is_zero,
    // pulses to be counted, and their directions
    input  wire           i_px,
    input  wire           i_nx,
    input  wire           i_py,
    input  wire           i_ny,
    output wire           o_done,
    // registers
    output reg  [1:0]     o_quadrant,
    output reg  [2:0]     o_crossings,
    output reg            o_cw,
    output reg  [N+1:0]   o_jex,
    output reg  [N+1:0]   o_jey,
    // the quadrant decoded: whether it is the last, the axis fed towards zero (the other is fed
    // away from it), the signs of the axes' pulses
    output reg            o_last,
    output reg            o_towards_is_y,
    output reg            o_feeds_nx,
    output reg            o_feeds_ny,
    // what the last look saw: counters at zero, axes that stand, and that what is left is to be
    // stepped out
    output reg            o_at_end_x,
    output reg            o_at_end_y,
    output reg            o_stands_x,
    output reg            o_stands_y,
    output reg            o_stepping_out,
    // this cycle's pulses as the quadrant has them: their directions, and whether they make their coordinates smaller
    output reg            o_nx,
    output reg            o_ny,
    output reg            o_shrinks_x,
    output reg            o_shrinks_y
);
    assign o_done = o_last & o_jex == 0 & o_jey == 0;

    wire towards_is_zero = o_towards_is_y ? i_y_is_zero : i_x_is_zero;
    wire away_is_zero    = o_towards_is_y ? i_x_is_zero : i_y_is_zero;
    // The circle of radius 1 steps through its centre: the quadrant being left is kept there.
    wire crosses         = ~o_last & towards_is_zero & ~away_is_zero;

    // Each flip-flop of a look has the value that it gets without a crossing and with one (c); that
    // there is a crossing is known last of all. At a crossing, what was fed away from zero is fed
    // towards it.
    wire x_at_end       = o_jex == 0;
    wire y_at_end       = o_jey == 0;
    wire x_back         = o_jex[N+1];
    wire y_back         = o_jey[N+1];
    wire last_c         = o_crossings == 1;
    wire feeds_nx_c     = o_feeds_nx ^ o_towards_is_y;
    wire feeds_ny_c     = o_feeds_ny ^ ~o_towards_is_y;
    wire x_stands       = o_last & (x_at_end | (x_back ^ o_feeds_nx));
    wire y_stands       = o_last & (y_at_end | (y_back ^ o_feeds_ny));
    wire x_stands_c     = last_c & (x_at_end | (x_back ^ feeds_nx_c));
    wire y_stands_c     = last_c & (y_at_end | (y_back ^ feeds_ny_c));
    wire stepping_out   = (x_stands & y_stands) | (x_stands & i_x_is_zero)
                        | (y_stands & i_y_is_zero);
    wire stepping_out_c = (x_stands_c & y_stands_c) | (x_stands_c & i_x_is_zero)
                        | (y_stands_c & i_y_is_zero);
    // In the last quadrant every pulse leads to the end point, stepped out or not.
    wire nx             = o_last ? x_back : o_feeds_nx;
    wire ny             = o_last ? y_back : o_feeds_ny;
    wire nx_c           = last_c ? x_back : feeds_nx_c;
    wire ny_c           = last_c ? y_back : feeds_ny_c;

    // The same after a load: the quadrants I, II, III, IV are 0 to 3, counter-clockwise.
    wire load_last         = i_crossings == 0;
    wire load_towards_is_y = i_quadrant[0] ^ i_cw;
    wire load_feeds_nx     = ~i_quadrant[1] ^ i_cw;
    wire load_feeds_ny     = i_quadrant[1] ^ i_quadrant[0] ^ i_cw;
    wire load_x_at_end     = i_jex == 0;
    wire load_y_at_end     = i_jey == 0;
    wire load_x_runs_back  = load_last & (i_jex[N+1] ^ load_feeds_nx);
    wire load_y_runs_back  = load_last & (i_jey[N+1] ^ load_feeds_ny);
    wire load_x_stands     = (load_last & load_x_at_end) | load_x_runs_back;
    wire load_y_stands     = (load_last & load_y_at_end) | load_y_runs_back;

    // -1 for a positive pulse, +1 for a negative one.
    wire [N+1:0] count_x = {{(N+1){~i_nx}}, 1'b1};
    wire [N+1:0] count_y = {{(N+1){~i_ny}}, 1'b1};

    always @(posedge i_clk)
        if (i_rst) begin
            o_quadrant  <= 2'd0;
            o_crossings <= 3'd0;
            o_cw        <= 1'b0;
            o_jex       <= {(N+2){1'b0}};
            o_jey       <= {(N+2){1'b0}};
        end else if (i_load) begin
            o_quadrant  <= i_quadrant;
            o_crossings <= i_crossings;
            o_cw        <= i_cw;
            o_jex       <= i_jex;
            o_jey       <= i_jey;
        end else begin
            if (i_px) o_jex <= o_jex + count_x;
            if (i_py) o_jey <= o_jey + count_y;
            if (i_look & crosses) begin
                o_quadrant  <= o_cw ? o_quadrant - 2'd1 : o_quadrant + 2'd1;
                o_crossings <= o_crossings - 3'd1;
            end
        end

    always @(posedge i_clk)
        if (i_rst) begin
            o_last         <= 1'b1;
            o_towards_is_y <= 1'b0;
            o_feeds_nx     <= 1'b1;
            o_feeds_ny     <= 1'b0;
            o_at_end_x     <= 1'b1;
            o_at_end_y     <= 1'b1;
            o_stands_x     <= 1'b1;
            o_stands_y     <= 1'b1;
            o_stepping_out <= 1'b1;
            o_nx           <= 1'b0;
            o_ny           <= 1'b0;
            o_shrinks_x    <= 1'b0;
            o_shrinks_y    <= 1'b0;
        end else if (i_load) begin
            o_last         <= load_last;
            o_towards_is_y <= load_towards_is_y;
            o_feeds_nx     <= load_feeds_nx;
            o_feeds_ny     <= load_feeds_ny;
            o_at_end_x     <= load_x_at_end;
            o_at_end_y     <= load_y_at_end;
            o_stands_x     <= load_x_stands;
            o_stands_y     <= load_y_stands;
            o_stepping_out <= load_x_stands & load_y_stands;
            o_nx           <= load_feeds_nx ^ load_x_runs_back;
            o_ny           <= load_feeds_ny ^ load_y_runs_back;
            o_shrinks_x    <= ~load_towards_is_y ^ load_x_runs_back;
            o_shrinks_y    <= load_towards_is_y ^ load_y_runs_back;
        end else if (i_look) begin
            o_last         <= crosses ? last_c : o_last;
            o_towards_is_y <= crosses ^ o_towards_is_y;
            o_feeds_nx     <= crosses ? feeds_nx_c : o_feeds_nx;
            o_feeds_ny     <= crosses ? feeds_ny_c : o_feeds_ny;
            o_at_end_x     <= x_at_end;
            o_at_end_y     <= y_at_end;
            o_stands_x     <= crosses ? x_stands_c : x_stands;
            o_stands_y     <= crosses ? y_stands_c : y_stands;
            o_stepping_out <= crosses ? stepping_out_c : stepping_out;
            o_nx           <= crosses ? nx_c : nx;
            o_ny           <= crosses ? ny_c : ny;
            o_shrinks_x    <= crosses ? o_towards_is_y ^ nx_c ^ feeds_nx_c
                                      : ~o_towards_is_y ^ nx ^ o_feeds_nx;
            o_shrinks_y    <= crosses ? ~o_towards_is_y ^ ny_c ^ feeds_ny_c
                                      : o_towards_is_y ^ ny ^ o_feeds_ny;
        end
endmodule
