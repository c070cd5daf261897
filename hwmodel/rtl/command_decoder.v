// Turns a command into the first contents of an engine's registers, or refuses it.
//
// A command is what the software gives: end points in pulses, signed. The engines want magnitudes,
// quadrants, shifts. That takes some clocks, and one adder at a time:
//
//   idle       takes a command
//   magnitude  |start|, |end|; end counters <- end - start
//   check      what can be refused at once is; quadrants, crossings
//   square     R^2 = x^2 + y^2, a bit of each in two clocks, from the lowest; with it the sign of the
//              vector product of start and end, which tells a full turn from none when both lie in
//              one quadrant
//   turn       four crossings if the end does not lie ahead
//   root       R, a bit a clock
//   round      R, rounded up
//   end_x, _y  the largest coordinate: that of the circle or of the end point
//   grow       what the textbook's arc grows by when it crosses an axis
//   fits       refused if the registers do not hold it
//   shift      left-shift normalization, a bit a clock
//   finish     presets, signs
//   put        into the queue
//
// From the clock that takes it, an arc needs up to 4N + 13 clocks, a DDA line N + 5, any other 5.
module command_decoder #(
    parameter N    = 24,
    parameter AXES = 2,
    // bits of a period
    parameter P    = 24,
    // bits of a coordinate: N and the sign; those of a 32-bit processor are as wide as they get
    parameter W    = N < 32 ? N + 1 : 32
) (
    input  wire              i_clk,
    input  wire              i_rst,
    // a command, taken when ready
    input  wire              i_valid,
    output wire              o_ready,
    // 0 dda_line, 1 dda_arc, 2 dda_centred_arc, 3 ppc_line, 4 ppc_arc, 5 brm_line
    input  wire [2:0]        i_curve,
    // arcs: from where, about the origin; x lowest
    input  wire [2*W-1:0]    i_start,
    input  wire [AXES*W-1:0] i_end,
    input  wire              i_cw,
    // dda_line and dda_arc: 0 zero, 1 half, 2 full
    input  wire [1:0]        i_preset,
    // the dda curves
    input  wire              i_normalize,
    // clocks from one cycle to the next, at least 6
    input  wire [P-1:0]      i_period,
    // forgets the refused command; until then no other is taken
    input  wire              i_clear,
    // 0 none, 1 no such curve, 2 no such preset, 3 a coordinate that is out of range or of an axis
    // that the curve does not have, 4 an arc from or to its centre, 5 too large for the registers,
    // 6 too short a period
    output reg  [2:0]        o_error,
    // the decoded command is in the registers, and has been put away when ready
    output wire              o_valid,
    input  wire              i_ready,
    output reg  [3:0]        o_state,
    output reg  [2:0]        o_curve,
    output reg  [P-1:0]      o_period,
    output reg  [AXES*N-1:0] o_first,
    output reg  [AXES-1:0]   o_negative,
    output reg  [N-1:0]      o_jrx,
    output reg  [N-1:0]      o_jry,
    output reg  [N-1:0]      o_unit,
    output reg  [N:0]        o_je,
    output reg  [1:0]        o_quadrant,
    output reg  [2:0]        o_crossings,
    output reg               o_cw,
    output reg  [N+1:0]      o_jex,
    output reg  [N+1:0]      o_jey,
    // registers on the way there
    output reg  [1:0]        o_preset,
    output reg               o_normalize,
    output reg  [2*W-1:0]    o_start,
    output reg  [AXES*W-1:0] o_end,
    output reg  [1:0]        o_start_negative,
    output reg  [6:0]        o_count,
    output reg  [W-1:0]      o_bits_x,
    output reg  [W-1:0]      o_bits_y,
    output reg  [W:0]        o_high,
    output reg  [W-1:0]      o_low,
    output reg  [W+1:0]      o_turn,
    output reg               o_turn_rest,
    output reg  [N+1:0]      o_root,
    output reg  [N+1:0]      o_rest
);
    localparam DDA_LINE = 3'd0, DDA_ARC = 3'd1, DDA_CENTRED_ARC = 3'd2, PPC_LINE = 3'd3,
               PPC_ARC = 3'd4, BRM_LINE = 3'd5;
    localparam IDLE = 4'd0, MAGNITUDE = 4'd1, CHECK = 4'd2, SQUARE = 4'd3, TURN = 4'd4,
               ROOT = 4'd5, ROUND = 4'd6, END_X = 4'd7, END_Y = 4'd8, GROW = 4'd9, FITS = 4'd10,
               SHIFT = 4'd11, FINISH = 4'd12, PUT = 4'd13;
    localparam NONE = 3'd0, CURVE = 3'd1, PRESET = 3'd2, COORDINATE = 3'd3, CENTRE = 3'd4,
               TOO_LARGE = 3'd5, PERIOD = 3'd6;
    // How far the textbook's circle may grow, see the software's Arc::bits.
    localparam [N+1:0] GROWTH  = 5;
    localparam [P-1:0] SHORTEST = 6;
    localparam integer LAST_SQUARE = 2*W - 1, LAST_ROOT = W - 1;

    assign o_ready = o_state == IDLE & o_error == NONE;
    assign o_valid = o_state == PUT;

    wire is_arc = o_curve == DDA_ARC | o_curve == DDA_CENTRED_ARC | o_curve == PPC_ARC;
    // Arcs and point-by-point comparison have x and y only.
    wire is_flat = is_arc | o_curve == PPC_LINE;

    wire [W-1:0] start_x = o_start[0 +: W], start_y = o_start[W +: W];
    wire [W-1:0] end_x   = o_end[0 +: W],   end_y   = o_end[W +: W];

    // Magnitudes, and what is wrong with them: that of the most negative number has a sign again.
    wire [AXES-1:0] end_sign, end_is_wide, end_is_zero;
    wire [AXES*W-1:0] end_magnitude;
    wire [AXES*N-1:0] end_first;
    genvar axis;
    generate
        for (axis = 0; axis < AXES; axis = axis + 1) begin : axes
            wire [W-1:0] part = o_end[axis*W +: W];
            assign end_sign[axis]    = part[W-1];
            assign end_is_wide[axis] = part[W-1];
            assign end_is_zero[axis] = part == 0;
            assign end_magnitude[axis*W +: W]
                = (part ^ {W{part[W-1]}}) + {{(W-1){1'b0}}, part[W-1]};
            if (N < 32) assign end_first[axis*N +: N] = part[N-1:0];
            else        assign end_first[axis*N +: N] = {{(N+1-W){1'b0}}, part[W-2:0]};
        end
    endgenerate
    wire [AXES-1:0] flat_axes = {{(AXES-2){1'b0}}, 2'b11};
    wire [W-1:0] magnitude_x = (start_x ^ {W{start_x[W-1]}}) + {{(W-1){1'b0}}, start_x[W-1]};
    wire [W-1:0] magnitude_y = (start_y ^ {W{start_y[W-1]}}) + {{(W-1){1'b0}}, start_y[W-1]};
    wire [N-1:0] first_x, first_y;
    generate
        if (N < 32) begin : narrow
            assign first_x = start_x[N-1:0];
            assign first_y = start_y[N-1:0];
        end else begin : wide
            assign first_x = {{(N+1-W){1'b0}}, start_x[W-2:0]};
            assign first_y = {{(N+1-W){1'b0}}, start_y[W-2:0]};
        end
    endgenerate

    // The quadrant that a point is in, and on an axis the one that the sense leads into. I, II,
    // III, IV are 0 to 3.
    function [1:0] entered(input nx, input zx, input ny, input zy, input cw);
        if (zy)      entered = nx ? (cw ? 2'd1 : 2'd2) : (cw ? 2'd3 : 2'd0);
        else if (ny) entered = (cw ? nx | zx : nx) ? 2'd2 : 2'd3;
        else         entered = (cw ? nx : nx | zx) ? 2'd1 : 2'd0;
    endfunction
    wire start_zx = start_x == 0, start_zy = start_y == 0;
    wire [1:0] first_quadrant = entered(o_start_negative[0], start_zx, o_start_negative[1],
                                        start_zy, o_cw);
    // The quadrant that is left at the end point is the one that the other sense enters there.
    wire [1:0] last_quadrant  = entered(o_negative[0], end_is_zero[0], o_negative[1],
                                        end_is_zero[1], ~o_cw);
    wire [1:0] quadrants = o_cw ? first_quadrant - last_quadrant : last_quadrant - first_quadrant;

    wire [2:0] refusal =
        o_curve > BRM_LINE ? CURVE
        : (o_curve == DDA_LINE | o_curve == DDA_ARC) & o_preset == 2'd3 ? PRESET
        : |end_is_wide | (is_flat & |(~end_is_zero & ~flat_axes))
          | (is_arc & (start_x[W-1] | start_y[W-1])) ? COORDINATE
        : is_arc & ((start_zx & start_zy) | (end_is_zero[0] & end_is_zero[1])) ? CENTRE
        : o_period < SHORTEST ? PERIOD
        : NONE;

    // Square: what is summed up moves down a place for each bit, so the adders are as wide as a
    // coordinate. Of the vector product only the sign is asked for, and whether anything is left.
    wire         is_y    = o_count[0];
    wire         bit_now = is_y ? o_bits_y[0] : o_bits_x[0];
    wire [W-1:0] factor  = (is_y ? start_y : start_x) & {W{bit_now}};
    wire [W-1:0] crossed = (is_y ? end_x : end_y) & {W{bit_now}};
    wire [W:0]   high    = o_high + {1'b0, factor};
    wire [W+1:0] turn    = o_turn + ({2'b00, crossed} ^ {(W+2){is_y}}) + {{(W+1){1'b0}}, is_y};
    // Counter-clockwise the end lies ahead if the vector product is positive; that of the
    // magnitudes has its sign turned in II and IV.
    wire is_ahead = (o_turn != 0 | o_turn_rest) & o_turn[W+1] == (o_quadrant[0] ^ o_cw);

    // Root: the next two bits of the square, and what must be left of them for a one.
    wire [N+3:0] rest      = {o_rest, o_high[W-1:W-2]};
    wire [N+4:0] rest_left = {1'b0, rest} - {1'b0, o_root, 2'b01};
    wire         is_one    = ~rest_left[N+4];

    // Largest coordinate.
    wire [N+1:0] end_now = {{(N+2-W){1'b0}}, o_state == END_X ? end_x : end_y};
    // The circle of 32-bit coordinates, and the headroom bit.
    wire is_out_of_range = o_root[N+1:W-1] != 0;
    wire is_too_wide     = o_root[N+1:N] != 0 | (o_curve == DDA_CENTRED_ARC & o_root[N-1]);

    // Shift: a line until a top bit is set, the textbook's arc until its second bit is, both arcs
    // as long as the largest coordinate fits.
    reg [N-1:0] some;
    integer     number;
    always @* begin
        some = {N{1'b0}};
        for (number = 0; number < AXES; number = number + 1)
            some = some | o_first[number*N +: N];
    end
    wire has_room = o_curve == DDA_LINE ? ~some[N-1] & some != 0
                  : o_curve == DDA_ARC ? ~some[N-1] & ~some[N-2] & ~o_root[N-1]
                  : ~o_root[N-2];

    // Finish.
    wire [N-1:0] half    = {1'b1, {(N-1){1'b0}}};
    wire [N-1:0] preset  = o_preset == 2'd0 ? {N{1'b0}} : o_preset == 2'd1 ? half : {N{1'b1}};
    wire [N-1:0] first_0 = o_first[0 +: N], first_1 = o_first[N +: N];
    wire         behind  = o_start_negative[1] ^ o_cw;
    wire [N-1:0] ahead   = half + ({1'b0, first_1[N-1:1]} ^ {N{behind}})
                         + {{(N-1){1'b0}}, behind};
    wire [N-1:0] signed_0 = (first_0 ^ {N{o_start_negative[0]}})
                          + {{(N-1){1'b0}}, o_start_negative[0]};
    wire [N-1:0] signed_1 = (first_1 ^ {N{o_start_negative[1]}})
                          + {{(N-1){1'b0}}, o_start_negative[1]};

    always @(posedge i_clk)
        if (i_rst) begin
            o_state          <= IDLE;
            o_error          <= NONE;
            o_curve          <= 3'd0;
            o_period         <= {P{1'b0}};
            o_first          <= {AXES*N{1'b0}};
            o_negative       <= {AXES{1'b0}};
            o_jrx            <= {N{1'b0}};
            o_jry            <= {N{1'b0}};
            o_unit           <= {N{1'b0}};
            o_je             <= {(N+1){1'b0}};
            o_quadrant       <= 2'd0;
            o_crossings      <= 3'd0;
            o_cw             <= 1'b0;
            o_jex            <= {(N+2){1'b0}};
            o_jey            <= {(N+2){1'b0}};
            o_preset         <= 2'd0;
            o_normalize      <= 1'b0;
            o_start          <= {2*W{1'b0}};
            o_end            <= {AXES*W{1'b0}};
            o_start_negative <= 2'b00;
            o_count          <= 7'd0;
            o_bits_x         <= {W{1'b0}};
            o_bits_y         <= {W{1'b0}};
            o_high           <= {(W+1){1'b0}};
            o_low            <= {W{1'b0}};
            o_turn           <= {(W+2){1'b0}};
            o_turn_rest      <= 1'b0;
            o_root           <= {(N+2){1'b0}};
            o_rest           <= {(N+2){1'b0}};
        end else begin
            if (i_clear) o_error <= NONE;
            case (o_state)
                IDLE: if (i_valid & o_ready) begin
                    o_state     <= MAGNITUDE;
                    o_curve     <= i_curve;
                    o_period    <= i_period;
                    o_cw        <= i_cw;
                    o_preset    <= i_preset;
                    o_normalize <= i_normalize;
                    o_start     <= i_start;
                    o_end       <= i_end;
                end
                MAGNITUDE: begin
                    o_state          <= CHECK;
                    o_start          <= {magnitude_y, magnitude_x};
                    o_start_negative <= {start_y[W-1], start_x[W-1]};
                    o_end            <= end_magnitude;
                    o_negative       <= end_sign;
                    o_jex            <= {{(N+2-W){end_x[W-1]}}, end_x}
                                      - {{(N+2-W){start_x[W-1]}}, start_x};
                    o_jey            <= {{(N+2-W){end_y[W-1]}}, end_y}
                                      - {{(N+2-W){start_y[W-1]}}, start_y};
                end
                CHECK: begin
                    o_error     <= refusal;
                    o_state     <= refusal != NONE ? IDLE
                                 : is_arc ? SQUARE
                                 : o_curve == DDA_LINE ? SHIFT : FINISH;
                    o_quadrant  <= first_quadrant;
                    o_crossings <= {1'b0, quadrants};
                    o_first     <= end_first;
                    if (o_curve == DDA_ARC)
                        o_first[2*N-1:0] <= {first_x, first_y};
                    else if (is_arc)
                        o_first[2*N-1:0] <= {first_y, first_x};
                    o_unit      <= {{(N-1){1'b0}}, 1'b1};
                    o_je        <= {1'b1, {N{1'b0}}};
                    o_count     <= 7'd0;
                    o_bits_x    <= start_x;
                    o_bits_y    <= start_y;
                    o_high      <= {(W+1){1'b0}};
                    o_low       <= {W{1'b0}};
                    o_turn      <= {(W+2){1'b0}};
                    o_turn_rest <= 1'b0;
                    o_root      <= {(N+2){1'b0}};
                    o_rest      <= {(N+2){1'b0}};
                end
                SQUARE: begin
                    o_high <= is_y ? high >> 1 : high;
                    o_turn <= is_y ? {turn[W+1], turn[W+1:1]} : turn;
                    if (is_y) begin
                        o_low       <= {high[0], o_low[W-1:1]};
                        o_turn_rest <= o_turn_rest | turn[0];
                        o_bits_x    <= o_bits_x >> 1;
                        o_bits_y    <= o_bits_y >> 1;
                    end
                    o_count <= o_count + 7'd1;
                    if (o_count == LAST_SQUARE[6:0]) o_state <= TURN;
                end
                TURN: begin
                    o_state <= ROOT;
                    o_count <= 7'd0;
                    if (o_crossings == 0 & ~is_ahead) o_crossings <= 3'd4;
                end
                ROOT: begin
                    o_high   <= {o_high[W-2:0], o_low[W-1:W-2]};
                    o_low    <= o_low << 2;
                    o_root   <= {o_root[N:0], is_one};
                    o_rest   <= is_one ? rest_left[N+1:0] : rest[N+1:0];
                    o_count  <= o_count + 7'd1;
                    if (o_count == LAST_ROOT[6:0]) o_state <= ROUND;
                end
                ROUND: begin
                    o_state <= END_X;
                    if (o_rest != 0) o_root <= o_root + 1'b1;
                end
                END_X, END_Y: begin
                    o_state <= o_state == END_X ? END_Y : GROW;
                    if (end_now > o_root) o_root <= end_now;
                end
                GROW: begin
                    o_state <= is_out_of_range ? IDLE : FITS;
                    if (is_out_of_range) o_error <= TOO_LARGE;
                    if (o_curve == DDA_ARC & o_crossings != 0) o_root <= o_root + GROWTH;
                end
                FITS: begin
                    o_state <= is_too_wide ? IDLE : o_curve == PPC_ARC ? FINISH : SHIFT;
                    if (is_too_wide) o_error <= TOO_LARGE;
                end
                SHIFT:
                    if (o_normalize & has_room) begin
                        o_first <= o_first << 1;
                        o_unit  <= o_unit << 1;
                        o_je    <= o_je >> 1;
                        o_root  <= o_root << 1;
                    end else
                        o_state <= FINISH;
                FINISH: begin
                    o_state <= PUT;
                    o_jrx   <= o_curve == DDA_CENTRED_ARC ? ahead : preset;
                    o_jry   <= o_curve == DDA_CENTRED_ARC ? half : preset;
                    if (o_curve == DDA_CENTRED_ARC) o_first[2*N-1:0] <= {signed_1, signed_0};
                end
                default: if (i_ready) o_state <= IDLE;
            endcase
        end
endmodule
