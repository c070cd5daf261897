// What the textbook's DDA arc always does, for every command, sensible or not.
module dda_arc_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] jvx,
    input wire [N-1:0] jvy,
    input wire [N-1:0] preset,
    input wire [N-1:0] unit,
    input wire [1:0]   quadrant,
    input wire [2:0]   crossings,
    input wire         cw,
    input wire [N+1:0] jex,
    input wire [N+1:0] jey
);
    localparam M = 2*N + 8;

    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative, quadrant_q;
    wire         done, cw_q;
    wire [N-1:0] unit_q;
    wire [2:0]   crossings_q;
    wire [N-1:0] jvx_q, jvy_q, jrx_q, jry_q;
    wire [N+1:0] jex_q, jey_q;

    dda_arc #(.N(N)) arc (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_jvx(jvx), .i_jvy(jvy),
        .i_preset(preset), .i_unit(unit), .i_quadrant(quadrant), .i_crossings(crossings),
        .i_cw(cw), .i_jex(jex), .i_jey(jey), .o_pulse(pulse), .o_negative(negative),
        .o_done(done), .o_unit(unit_q), .o_cw(cw_q), .o_jvx(jvx_q), .o_jvy(jvy_q), .o_jrx(jrx_q), .o_jry(jry_q),
        .o_quadrant(quadrant_q), .o_crossings(crossings_q), .o_jex(jex_q), .o_jey(jey_q)
    );

    // The sweep's decoder once more, from the outputs.
    wire nx = ~quadrant_q[1] ^ cw_q;
    wire ny = quadrant_q[1] ^ quadrant_q[0] ^ cw_q;
    wire last = crossings_q == 0;
    wire x_stands = last & (jex_q == 0 | (jex_q[N+1] ^ nx));
    wire y_stands = last & (jey_q == 0 | (jey_q[N+1] ^ ny));
    wire stepping_out = (x_stands & y_stands) | (x_stands & jvy_q == 0) | (y_stands & jvx_q == 0);
    wire adds_x = en & ~done & ~stepping_out & ~x_stands;
    wire adds_y = en & ~done & ~stepping_out & ~y_stands;

    // Net pulses, and the exact sums that the remainders come from (stepping out adds none).
    reg  [N+1:0] net_x = 0, net_y = 0, far_x = 0, far_y = 0;
    reg  [M-1:0] sum_x = 0, sum_y = 0, carries_x = 0, carries_y = 0;
    always @(posedge clk)
        if (first | load) begin
            net_x     <= 0;
            net_y     <= 0;
            far_x     <= first ? 0 : jex;
            far_y     <= first ? 0 : jey;
            sum_x     <= first ? 0 : {{(M-N){1'b0}}, preset};
            sum_y     <= first ? 0 : {{(M-N){1'b0}}, preset};
            carries_x <= 0;
            carries_y <= 0;
        end else begin
            if (pulse[0]) net_x <= negative[0] ? net_x - 1'b1 : net_x + 1'b1;
            if (pulse[1]) net_y <= negative[1] ? net_y - 1'b1 : net_y + 1'b1;
            if (adds_x) sum_x <= sum_x + {{(M-N){1'b0}}, jvx_q};
            if (adds_y) sum_y <= sum_y + {{(M-N){1'b0}}, jvy_q};
            if (adds_x & pulse[0]) carries_x <= carries_x + 1'b1;
            if (adds_y & pulse[1]) carries_y <= carries_y + 1'b1;
        end

    always @* if (!first) begin
        assert (!((done | ~en) & pulse != 0));
        // In the last quadrant no pulse of an axis whose end counter is spent.
        assert (!(crossings_q == 0 & jex_q == 0 & pulse[0]));
        assert (!(crossings_q == 0 & jey_q == 0 & pulse[1]));
        // Stepping out leads to the end point.
        if (stepping_out & pulse[0]) assert (negative[0] == jex_q[N+1]);
        if (stepping_out & pulse[1]) assert (negative[1] == jey_q[N+1]);
        // Pulses and end counter together are the way that was asked for: done means there.
        assert (net_x + jex_q == far_x);
        assert (net_y + jey_q == far_y);
        if (done) assert (net_x == far_x && net_y == far_y);
        // The overflow is the pulse.
        assert ((carries_x << N) + {{(M-N){1'b0}}, jrx_q} == sum_x);
        assert ((carries_y << N) + {{(M-N){1'b0}}, jry_q} == sum_y);
    end
endmodule
