// Circular arc by digital integration, staggered and centred: the circuit that keeps one pulse.
//
//   0 add x   S <- JRx - y
//   1 move x  JRx takes the sum; a carry is a +x pulse, a borrow a -x pulse, and x takes it
//   2 add y   S <- JRy + x, with the x that already has that pulse
//   3 move y  the same for y
//
// That is counter-clockwise; clockwise both signs are turned. The coordinates are signed and carry
// the factor i_unit = 2^Q. What is staggered cannot be added at once: the beats share one adder.
module dda_centred_arc #(
    parameter N = 24
) (
    input  wire         i_clk,
    input  wire         i_rst,
    // pulse source: begins a cycle, when none is under way
    input  wire         i_en,
    // command: the registers' first contents
    input  wire         i_load,
    input  wire [N-1:0] i_x,
    input  wire [N-1:0] i_y,
    input  wire [N-1:0] i_jrx,
    input  wire [N-1:0] i_jry,
    input  wire [N-1:0] i_unit,
    input  wire [1:0]   i_quadrant,
    input  wire [2:0]   i_crossings,
    input  wire         i_cw,
    input  wire [N+1:0] i_jex,
    input  wire [N+1:0] i_jey,
    // pulses of this clock, and their directions
    output wire [1:0]   o_pulse,
    output wire [1:0]   o_negative,
    output wire         o_done,
    // registers
    output reg  [1:0]   o_beat,
    output reg  [N-1:0] o_unit,
    output reg  [N-1:0] o_x,
    output reg  [N-1:0] o_y,
    output reg  [N-1:0] o_jrx,
    output reg  [N-1:0] o_jry,
    output reg  [N+1:0] o_sum,
    // registers of the sweep
    output wire [1:0]   o_quadrant,
    output wire [2:0]   o_crossings,
    output wire         o_cw,
    output wire [N+1:0] o_jex,
    output wire [N+1:0] o_jey,
    output wire         o_last,
    output wire         o_towards_is_y,
    output wire         o_feeds_nx,
    output wire         o_feeds_ny,
    output wire         o_at_end_x,
    output wire         o_at_end_y,
    output wire         o_stands_x,
    output wire         o_stands_y,
    output wire         o_stepping_out,
    output wire         o_nx,
    output wire         o_ny,
    output wire         o_shrinks_x,
    output wire         o_shrinks_y
);
    localparam ADD_X = 2'd0, MOVE_X = 2'd1, ADD_Y = 2'd2, MOVE_Y = 2'd3;

    wire is_last;
    // Without the end counters' zero detectors: what is added after the end is not used.
    wire begins = o_beat == ADD_X & i_en;
    wire is_y   = o_beat[1];

    // A remainder is unsigned, a coordinate signed: in N + 2 bits the sum's two top bits are 00
    // (no pulse), 01 (carry) or 11 (borrow).
    wire         subtracts = is_y == o_cw;
    wire [N-1:0] integrand = is_y ? o_x : o_y;
    wire [N-1:0] remainder = is_y ? o_jry : o_jrx;
    wire [N+1:0] sum       = {2'b00, remainder}
                           + ({{2{integrand[N-1]}}, integrand} ^ {(N+2){subtracts}})
                           + {{(N+1){1'b0}}, subtracts};

    wire px = o_beat == MOVE_X & (o_stepping_out ? ~o_at_end_x : o_sum[N] & ~o_stands_x);
    wire nx = o_stepping_out ? o_nx : o_sum[N+1];
    wire py = o_beat == MOVE_Y & (o_stepping_out ? ~o_at_end_y : o_sum[N] & ~o_stands_y);
    wire ny = o_stepping_out ? o_ny : o_sum[N+1];

    assign o_pulse    = {py, px};
    assign o_negative = {ny, nx};
    assign o_done     = o_beat == ADD_X & is_last;

    wire [N-1:0] x_next = o_x + (o_unit ^ {N{nx}}) + {{(N-1){1'b0}}, nx};
    wire [N-1:0] y_next = o_y + (o_unit ^ {N{ny}}) + {{(N-1){1'b0}}, ny};

    sweep #(.N(N)) sweep (
        .i_clk         (i_clk),
        .i_rst         (i_rst),
        .i_load        (i_load),
        .i_quadrant    (i_quadrant),
        .i_crossings   (i_crossings),
        .i_cw          (i_cw),
        .i_jex         (i_jex),
        .i_jey         (i_jey),
        .i_look        (begins),
        .i_x_is_zero   (o_x == 0),
        .i_y_is_zero   (o_y == 0),
        .i_px          (px),
        .i_nx          (nx),
        .i_py          (py),
        .i_ny          (ny),
        .o_done        (is_last),
        .o_quadrant    (o_quadrant),
        .o_crossings   (o_crossings),
        .o_cw          (o_cw),
        .o_jex         (o_jex),
        .o_jey         (o_jey),
        .o_last        (o_last),
        .o_towards_is_y(o_towards_is_y),
        .o_feeds_nx    (o_feeds_nx),
        .o_feeds_ny    (o_feeds_ny),
        .o_at_end_x    (o_at_end_x),
        .o_at_end_y    (o_at_end_y),
        .o_stands_x    (o_stands_x),
        .o_stands_y    (o_stands_y),
        .o_stepping_out(o_stepping_out),
        .o_nx          (o_nx),
        .o_ny          (o_ny),
        .o_shrinks_x   (o_shrinks_x),
        .o_shrinks_y   (o_shrinks_y)
    );

    always @(posedge i_clk)
        if (i_rst) begin
            o_beat <= ADD_X;
            o_unit <= {N{1'b0}};
            o_x    <= {N{1'b0}};
            o_y    <= {N{1'b0}};
            o_jrx  <= {N{1'b0}};
            o_jry  <= {N{1'b0}};
            o_sum  <= {(N+2){1'b0}};
        end else if (i_load) begin
            o_beat <= ADD_X;
            o_unit <= i_unit;
            o_x    <= i_x;
            o_y    <= i_y;
            o_jrx  <= i_jrx;
            o_jry  <= i_jry;
            o_sum  <= {(N+2){1'b0}};
        end else begin
            case (o_beat)
                ADD_X:   if (begins) begin
                    o_beat <= {1'b0, ~is_last};
                    o_sum  <= sum;
                end
                MOVE_X:  begin
                    o_beat <= ADD_Y;
                    if (~o_stepping_out & ~o_stands_x) o_jrx <= o_sum[N-1:0];
                end
                ADD_Y:   begin
                    o_beat <= MOVE_Y;
                    o_sum  <= sum;
                end
                default: begin
                    o_beat <= ADD_X;
                    if (~o_stepping_out & ~o_stands_y) o_jry <= o_sum[N-1:0];
                end
            endcase
            if (px) o_x <= x_next;
            if (py) o_y <= y_next;
        end
endmodule
