// The control of an arc's sweep: quadrant, crossings still to come, and the two end counters.
//
// The end counters hold the signed distance to the end point and count with every pulse. Before
// the last quadrant they stop nothing; in it, an axis whose counter is zero or has run through
// stands. When both stand, or one stands on a coordinate axis where it would feed the other
// nothing for ever, what is left is stepped out, a pulse a clock on each axis.
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
    // the pulses of this clock, taken at the edge that ends it
    input  wire           i_en,
    input  wire           i_px,
    input  wire           i_nx,
    input  wire           i_py,
    input  wire           i_ny,
    // whether the coordinates are zero: now, and after this clock's pulses
    input  wire           i_x_is_zero,
    input  wire           i_y_is_zero,
    input  wire           i_x_gets_zero,
    input  wire           i_y_gets_zero,
    // decoded: the axis fed towards zero (the other is fed away), each axis' direction
    output wire           o_towards_is_y,
    output wire           o_nx,
    output wire           o_ny,
    output wire           o_x_stands,
    output wire           o_y_stands,
    output wire           o_stepping_out,
    output wire           o_done,
    // registers
    output reg  [1:0]     o_quadrant,
    output reg  [2:0]     o_crossings,
    output reg            o_cw,
    output reg  [N+1:0]   o_jex,
    output reg  [N+1:0]   o_jey
);
    // Quadrants I, II, III, IV are 0 to 3, counter-clockwise.
    assign o_towards_is_y = o_quadrant[0] ^ o_cw;
    assign o_nx           = ~o_quadrant[1] ^ o_cw;
    assign o_ny           = o_quadrant[1] ^ o_quadrant[0] ^ o_cw;

    wire last   = o_crossings == 0;
    wire x_done = o_jex == 0;
    wire y_done = o_jey == 0;

    assign o_x_stands     = last & (x_done | (o_jex[N+1] ^ o_nx));
    assign o_y_stands     = last & (y_done | (o_jey[N+1] ^ o_ny));
    assign o_stepping_out = (o_x_stands & o_y_stands)
                          | (o_x_stands & i_x_is_zero)
                          | (o_y_stands & i_y_is_zero);
    assign o_done         = last & x_done & y_done;

    wire towards_gets_zero = o_towards_is_y ? i_y_gets_zero : i_x_gets_zero;
    wire away_gets_zero    = o_towards_is_y ? i_x_gets_zero : i_y_gets_zero;
    // The circle of radius 1 steps through its centre: the quadrant being left is kept there.
    wire crosses           = ~last & towards_gets_zero & ~away_gets_zero;

    // -1 for a positive pulse, +1 for a negative one.
    wire [N+1:0] count_x = {{(N+1){i_px & ~i_nx}}, i_px};
    wire [N+1:0] count_y = {{(N+1){i_py & ~i_ny}}, i_py};

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
        end else if (i_en) begin
            o_jex <= o_jex + count_x;
            o_jey <= o_jey + count_y;
            if (crosses) begin
                o_quadrant  <= o_cw ? o_quadrant - 2'd1 : o_quadrant + 2'd1;
                o_crossings <= o_crossings - 3'd1;
            end
        end
endmodule
