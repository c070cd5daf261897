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
    wire         done, beat;
    wire [N-1:0] unit_q;
    wire [2:0]   crossings_q;
    wire [N-1:0] jvx_q, jvy_q, jrx_q, jry_q;
    wire [N:0]   sumx_q, sumy_q;
    wire [N+1:0] jex_q, jey_q;
    wire cw_q, last_q, towards_is_y_q, feeds_nx_q, feeds_ny_q, at_end_x_q, at_end_y_q,
         stands_x_q, stands_y_q, stepping_out_q, nx_q, ny_q, shrinks_x_q, shrinks_y_q;

    dda_arc #(.N(N)) arc (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_jvx(jvx), .i_jvy(jvy),
        .i_preset(preset), .i_unit(unit), .i_quadrant(quadrant), .i_crossings(crossings),
        .i_cw(cw), .i_jex(jex), .i_jey(jey), .o_pulse(pulse), .o_negative(negative),
        .o_done(done), .o_beat(beat), .o_unit(unit_q), .o_jvx(jvx_q), .o_jvy(jvy_q),
        .o_jrx(jrx_q), .o_jry(jry_q), .o_sumx(sumx_q), .o_sumy(sumy_q),
        .o_quadrant(quadrant_q), .o_crossings(crossings_q), .o_jex(jex_q), .o_jey(jey_q),
        .o_cw(cw_q), .o_last(last_q), .o_towards_is_y(towards_is_y_q),
        .o_feeds_nx(feeds_nx_q), .o_feeds_ny(feeds_ny_q), .o_at_end_x(at_end_x_q),
        .o_at_end_y(at_end_y_q), .o_stands_x(stands_x_q), .o_stands_y(stands_y_q),
        .o_stepping_out(stepping_out_q), .o_nx(nx_q), .o_ny(ny_q),
        .o_shrinks_x(shrinks_x_q), .o_shrinks_y(shrinks_y_q)
    );

    // The sweep's decoder once more, from the other outputs.
    wire last     = crossings_q == 0;
    wire feeds_nx = ~quadrant_q[1] ^ cw_q;
    wire feeds_ny = quadrant_q[1] ^ quadrant_q[0] ^ cw_q;
    wire x_stands = last & (jex_q == 0 | (jex_q[N+1] ^ feeds_nx));
    wire y_stands = last & (jey_q == 0 | (jey_q[N+1] ^ feeds_ny));

    // Net pulses, and the exact sums that the remainders come from (stepping out adds none).
    wire         adds_x = beat & ~stepping_out_q & ~x_stands;
    wire         adds_y = beat & ~stepping_out_q & ~y_stands;
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
        // What is kept decoded is what the quadrant says.
        assert (last_q == last);
        assert (towards_is_y_q == (quadrant_q[0] ^ cw_q));
        assert (feeds_nx_q == feeds_nx && feeds_ny_q == feeds_ny);
        // In the second beat the last look and the sums are up to date.
        if (beat) begin
            assert (at_end_x_q == (jex_q == 0) && at_end_y_q == (jey_q == 0));
            assert (stands_x_q == x_stands && stands_y_q == y_stands);
            assert (!stepping_out_q | x_stands | y_stands);
            assert (stepping_out_q == ((x_stands & y_stands) | (x_stands & jvy_q == 0)
                                                             | (y_stands & jvx_q == 0)));
            assert (nx_q == (last ? jex_q[N+1] : feeds_nx));
            assert (ny_q == (last ? jey_q[N+1] : feeds_ny));
            assert (sumx_q == {1'b0, jrx_q} + {1'b0, jvx_q});
            assert (sumy_q == {1'b0, jry_q} + {1'b0, jvy_q});
        end
        // Pulses belong to the second beat, and none follows the end.
        assert (!((done | ~beat) & pulse != 0));
        // In the last quadrant no pulse of an axis whose end counter is spent.
        assert (!(last & jex_q == 0 & pulse[0]));
        assert (!(last & jey_q == 0 & pulse[1]));
        // Stepping out leads to the end point.
        if (stepping_out_q & pulse[0]) assert (negative[0] == jex_q[N+1]);
        if (stepping_out_q & pulse[1]) assert (negative[1] == jey_q[N+1]);
        // Pulses and end counter together are the way that was asked for: done means there.
        assert (net_x + jex_q == far_x);
        assert (net_y + jey_q == far_y);
        if (done) assert (net_x == far_x && net_y == far_y);
        // The overflow is the pulse.
        assert ((carries_x << N) + {{(M-N){1'b0}}, jrx_q} == sum_x);
        assert ((carries_y << N) + {{(M-N){1'b0}}, jry_q} == sum_y);
    end
endmodule
